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
from judge.practice.quiz import Topic, near_sets, next_cards, usual_kata
from judge.practice.review import Learner, card_reviews
from judge.practice.syllabus import Checklist

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


class Evening:
    """What to do this evening, after what a person did and how the topics stand."""

    def __init__(
        self,
        mine: Learner,
        cards: Sequence[Card],
        found: Sequence[Topic],
        checklist: Checklist,
        now: datetime,
    ) -> None:
        self._mine, self._cards, self._topics, self._now = mine, cards, found, now
        self._drilled, self._known = checklist.drilled(), card_reviews(mine.answers)
        self._own = next(iter(mine.from_own()), None)
        self._near = near_sets(self._own.name if self._own else "")

    def steps(self, hacks: Sequence[Hack]) -> Iterator[DrillStep]:
        """The commands in their order; `hacks` are the attempts at wrong programs."""
        close = {card.key for card in self._cards if not {*self._near}.isdisjoint(card.sets)}
        weak = [each for each in self._topics if not close.isdisjoint(each.weak)]
        first = max(weak, key=lambda each: len(each.open), default=None)
        quizzes = [self._quiz(each) for each in self._topics if each == first or self._quiz(each).due]
        yield from (step for step in quizzes or [self._quiz(None)] if step.new or step.due)
        if self._mine.solved:  # whoever breaks a program has written one
            yield from self._hack(hacks)
        yield from self._kata()
        for review in self._mine.due(self._now).due[:1]:
            yield DrillStep(f"judge start {review.name} --reset", _AGAIN, last=review.last)

    def _quiz(self, topic: Topic | None) -> DrillStep:
        """The cards of a topic, or any, of which so many are asked."""
        own = [card for card in self._cards if topic is None or topic.name in card.topics]
        weak = [each.weak for each in ([topic] if topic else self._topics)]
        asked = next_cards(own, self._known, self._now, _CARDS, near=self._near, weak=weak)[:_CARDS]
        due = len({review.name for review in self._known}.intersection(card.key for card in asked))
        minutes, name = _FEW if len(asked) <= _FEW else _CARDS, topic.name if topic else ""
        return DrillStep(f"judge quiz {name}".rstrip(), minutes, name, new=len(asked) - due, due=due)

    def _hack(self, hacks: Sequence[Hack]) -> Iterator[DrillStep]:
        """The first wrong program about an open topic that is not broken, in the own set or one beside it."""
        sets = [each for each in self._mine.sets if each.name in self._near]
        katas = [kata for each in sets for kata in self._mine.counted(each)]
        for topic in self._topics:
            shown = {kata.id: len({*topic.open}.intersection(map(_NAME, kata.skills))) for kata in katas}
            for kata in sorted(filter(lambda each: shown[each.id], katas), key=lambda each: -shown[each.id]):
                puzzles = read_puzzles(kata, self._drilled)
                own = [each for each in hacks if each.problem == kata.id]
                states = hack_states([each.mistake for each in puzzles], own)
                about = (each for each in puzzles if self._drilled.get(each.mistake) == topic.name)
                for each in about:
                    if states[each.mistake] is HackState.OPEN:
                        yield DrillStep(f"judge hack {kata.id} {each.number}", _HACK, topic.name)
                        return

    def _kata(self) -> Iterator[DrillStep]:
        """The first unsolved kata of the own set that shows an open skill; else the next one."""
        wanted = {skill for each in self._topics for skill in each.open}
        mine = self._mine
        katas = [*(mine.counted(self._own) if self._own else ()), usual_kata("", mine)]
        unsolved = [each for each in katas if each.id not in mine.solved]
        shows = (each for each in unsolved if not wanted.isdisjoint(map(_NAME, each.skills)))
        for kata in [*shows, *unsolved][:1]:
            runs = mine.own.get(kata.id, ())
            yield DrillStep(
                f"judge start {kata.id}", _KATA, title=kata.title, last=runs[-1].when if runs else None
            )
