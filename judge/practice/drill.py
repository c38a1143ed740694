"""An evening of practice: cards of the topics, a wrong program, a kata, and one to solve again."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from datetime import datetime
from operator import attrgetter

from msgspec import Struct

from judge.mistakes.puzzles import read_puzzles
from judge.practice.cards import Card
from judge.practice.events import Hack
from judge.practice.progress import HackState, hack_states
from judge.practice.quiz import Wanted, usual_kata
from judge.problem import Problem

_NAME = attrgetter("name")
_CARDS, _FEW = 10, 5  # that `judge quiz` asks; that take half as long
_HACK, _KATA, _AGAIN = 10, 20, 5  # minutes


class DrillStep(Struct, frozen=True):
    """A command, about how long it takes, and what it is: cards, a topic's wrong program or a kata.

    Of the cards so many are `new` and `due`. A kata has a `title`; `last` is when it was tried last.
    """

    command: str
    minutes: int
    topic: str = ""
    new: int = 0
    due: int = 0
    title: str = ""
    last: datetime | None = None


def evening(
    wanted: Wanted, cards: Sequence[Card], hacks: Sequence[Hack], now: datetime
) -> Iterator[DrillStep]:
    """The commands of an evening in their order; `hacks` are the attempts at wrong programs."""
    mine = wanted.mine
    close = {card.key for card in cards if not {*wanted.near}.isdisjoint(card.sets)}
    weak = [each for each in wanted.topics if not close.isdisjoint(each.weak)]
    first = max(weak, key=lambda each: len(each.open)).name if weak else ""
    quizzes = [_quiz(wanted, cards, each.name, now) for each in wanted.topics]
    quizzes = [each for each in quizzes if each.due or each.topic == first]
    yield from (each for each in quizzes or [_quiz(wanted, cards, "", now)] if each.new or each.due)
    if mine.solved and (hack := _hack(wanted, hacks)):  # whoever breaks a program has written one
        yield hack
    if kata := _kata(wanted):
        last = [run.when for run in mine.own.get(kata.id, ())][-1:]
        yield DrillStep(f"judge start {kata.id}", _KATA, title=kata.title, last=last[0] if last else None)
    for review in mine.due(now).due[:1]:
        yield DrillStep(f"judge start {review.name} --reset", _AGAIN, last=review.last)


def _quiz(wanted: Wanted, cards: Sequence[Card], topic: str, now: datetime) -> DrillStep:
    """The cards of a topic, or any, of which so many are asked."""
    own = [card for card in cards if not topic or topic in card.topics]
    asked = {card.key for card in wanted.of(own, now, _CARDS)[:_CARDS]}
    due = sum(review.name in asked for review in wanted.answered)
    minutes = _FEW if len(asked) <= _FEW else _CARDS
    return DrillStep(f"judge quiz {topic}".rstrip(), minutes, topic, new=len(asked) - due, due=due)


def _hack(wanted: Wanted, hacks: Sequence[Hack]) -> DrillStep | None:
    """The first wrong program about an open topic that is not broken, in the own set or one beside it."""
    drilled, mine = wanted.checklist.drilled(), wanted.mine
    katas = [kata for each in mine.sets if each.name in wanted.near for kata in mine.counted(each)]
    for topic in wanted.topics:
        shown = [(len({*topic.open}.intersection(map(_NAME, kata.skills))), kata) for kata in katas]
        for count, kata in sorted(shown, key=lambda each: -each[0]):
            puzzles = read_puzzles(kata, drilled) if count else ()
            own = [each for each in hacks if each.problem == kata.id]
            states = hack_states([each.mistake for each in puzzles], own)
            for each in puzzles:
                if drilled.get(each.mistake) == topic.name and states[each.mistake] is HackState.OPEN:
                    return DrillStep(f"judge hack {kata.id} {each.number}", _HACK, topic.name)
    return None


def _kata(wanted: Wanted) -> Problem | None:
    """The first unsolved kata of the own set that shows an open skill; else the next one."""
    open_, mine = {skill for each in wanted.topics for skill in each.open}, wanted.mine
    katas = [*(mine.counted(wanted.own) if wanted.own else ()), usual_kata("", mine)]
    unsolved = [each for each in katas if each.id not in mine.solved]
    shows = (each for each in unsolved if not open_.isdisjoint(map(_NAME, each.skills)))
    return next(shows, unsolved[0] if unsolved else None)
