"""Which cards are asked next, what to practise afterwards, and the mock interview: cards, a kata, cards."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from datetime import datetime
from itertools import chain, zip_longest
from pathlib import Path

from msgspec import Struct

from judge.errors import UsageError
from judge.practice.cards import Card
from judge.practice.events import Help, Run
from judge.practice.progress import solved
from judge.practice.review import Review, reviews
from judge.practice.syllabus import USUAL, find_set, read_checklist
from judge.problem import Problem, Tier, Verdict
from judge.problem.find import problem_folders, sound_problems
from judge.problem.model import FIRST
from judge.run.result import Result

_BEFORE, _AFTER = 6, 15  # minutes of the interview for each card before the kata, and after it


class Practise(Struct, frozen=True):
    """A question of the checklist to practise, and the commands that do."""

    question: str
    ask: str
    commands: tuple[str, ...]


def next_cards(
    cards: Sequence[Card], reviews: Sequence[Review], now: datetime, *, own: str = "", ahead: bool = False
) -> list[Card]:
    """The cards that are due, the longest overdue first, then new ones, those of the set `own` before others.

    With `ahead` all the others follow, the next due first.
    """
    by_key = {card.key: card for card in cards}
    known = [(by_key[review.name], review.is_due(now)) for review in reviews if review.name in by_key]
    answered = {card.key for card, _ in known}
    new = [card for card in cards if card.key not in answered]
    later = [card for card, is_due in known if not is_due]
    return [
        *(card for card, is_due in known if is_due),
        *sorted(new, key=lambda card: own not in card.sets),
        *(later if ahead else ()),
    ]


def next_due(cards: Iterable[Card], reviews: Iterable[Review]) -> datetime | None:
    """When the next of these cards is due; None where none was ever answered."""
    keys = {card.key for card in cards}
    return next((review.due for review in reviews if review.name in keys), None)


def to_practise(commands: Mapping[str, str], folders: Sequence[Path]) -> tuple[Practise, ...]:
    """The questions of the checklist that have a command, each with that and those of its katas.

    Raises ProblemError where the checklist is broken.
    """
    here = {folder.name for folder in problem_folders(folders)}
    found = []
    for row in read_checklist(folders).rows:
        if row.id in commands:
            starts = [f"judge start {kata}" for kata in row.katas if kata in here]
            found.append(Practise(row.id, row.ask, (commands[row.id], *starts)))
    return tuple(found)


# -- the interview -----------------------------------------------------------------------------------------


def plan(
    cards: Sequence[Card], minutes: int, answered: Sequence[Review], now: datetime
) -> tuple[Sequence[Card], Sequence[Card]]:
    """At least two cards before the kata and at least one after it, from easy to hard.

    They are about equally many of each set, and within a set in their order; cards of no set come last.
    """
    before, after = max(2, minutes // _BEFORE), max(1, minutes // _AFTER)
    sets = [FIRST, *(tier.value for tier in Tier), ""]
    of_set: dict[str, list[Card]] = {name: [] for name in sets}
    for card in next_cards(cards, answered, now, ahead=True):
        of_set[next((name for name in sets if name in card.sets), "")].append(card)
    in_turn = [card for turn in zip_longest(*of_set.values()) for card in turn if card][: before + after]
    found = [card for card in chain(*of_set.values()) if card in in_turn]
    return found[:before], found[before:]


def usual_kata(
    name: str, runs: Sequence[Run], helps: Sequence[Help], now: datetime, folders: Sequence[Path]
) -> Problem:
    """The kata of the set that is due; failing that, the first unsolved one past the first steps; or any."""
    every, _ = sound_problems(folders)
    problems = find_set(USUAL, every, folders).problems
    with suppress(UsageError):  # the name of a deck
        problems = find_set(name, every, folders).problems
    named = {problem.id: problem for problem in problems}
    due = [review.name for review in reviews(runs, helps) if review.is_due(now)]
    done = solved(runs)
    unsolved = [each for each in problems if each.id not in done]
    later = [each for each in unsolved if FIRST not in each.sets]
    return [*(named[name] for name in due if name in named), *later, *unsolved, *problems][0]


def lacking(problem: Problem, last: Result) -> tuple[str, ...]:
    """The skills of the problem that a run did not show."""
    passed = {group.name for group in last.groups if group.verdict is Verdict.AC}
    return tuple(skill.name for skill in problem.skills if not passed.issuperset(skill.groups))


def left_open(problem: Problem, skills: Sequence[str], folders: Sequence[Path]) -> dict[str, str]:
    """The questions of the checklist that need those skills, or else the kata, each with a command."""
    command = f"judge {'hint' if problem.has_hints else 'show'} {problem.id}"
    return {
        row.id: command
        for row in read_checklist(folders).rows
        if not {*skills}.isdisjoint(row.skills) or (not skills and problem.id in row.katas)
    }
