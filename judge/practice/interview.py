"""The mock interview: some cards, a kata, more cards, and what came of them."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from datetime import datetime
from pathlib import Path

from msgspec import Struct

from judge.errors import UsageError
from judge.practice.checklist import read_checklist
from judge.practice.events import Help, Run
from judge.practice.progress import Standing, standings
from judge.practice.quiz.cards import Card
from judge.practice.quiz.choose import next_cards, rising
from judge.practice.review import Review, reviews
from judge.practice.sets import FIRST, USUAL, find_set
from judge.problem import Problem, Tier, Verdict
from judge.run.result import Result

_BEFORE, _AFTER = 6, 15  # minutes of the interview for each card before the kata, and after it


class Plan(Struct, frozen=True):
    """The cards before the kata and after it."""

    before: tuple[Card, ...]
    after: tuple[Card, ...]

    @property
    def count(self) -> int:
        """How many cards it has."""
        return len(self.before) + len(self.after)


def plan(cards: Sequence[Card], minutes: int, answered: Sequence[Review], now: datetime) -> Plan:
    """At least two cards before the kata and one after it, from easy to hard."""
    before, after = max(2, minutes // _BEFORE), max(1, minutes // _AFTER)
    pool = next_cards(cards, answered, now, ahead=True)
    found = rising(pool, before + after, [FIRST, *(tier.value for tier in Tier)])
    return Plan(tuple(found[:before]), tuple(found[before:]))


def usual_kata(
    name: str, runs: Sequence[Run], helps: Sequence[Help], now: datetime, folders: Sequence[Path]
) -> Problem:
    """The kata of the set that is due; failing that, the first unsolved one past the first steps; or any."""
    problems = find_set(USUAL, folders).problems
    with suppress(UsageError):  # the name of a deck
        problems = find_set(name, folders).problems
    named = {problem.id: problem for problem in problems}
    for review in reviews(runs, helps):
        if review.name in named and review.is_due(now):
            return named[review.name]
    found = standings(runs)
    new = [each for each in problems if found.get(each.id, Standing()).passed is None]
    later = [each for each in new if FIRST not in each.sets]
    return (later or new or list(problems))[0]


class Held(Struct, frozen=True):
    """What became of the kata: how often its file was judged, and the last result."""

    problem: Problem
    file: str
    runs: int = 0
    last: Result | None = None

    def after(self, result: Result) -> Held:
        """The same once that result is there."""
        return Held(self.problem, self.file, self.runs + 1, result)

    @property
    def solved(self) -> bool:
        """Whether the last run was accepted with no group left out."""
        return self.last is not None and self.last.verdict is Verdict.AC

    @property
    def lacking(self) -> tuple[str, ...]:
        """The skills that the last run did not show; none where nothing was judged."""
        if self.last is None:
            return ()
        passed = {group.name for group in self.last.groups if group.verdict is Verdict.AC}
        return tuple(skill.name for skill in self.problem.skills if not passed.issuperset(skill.groups))

    def questions(self, folders: Sequence[Path]) -> dict[str, str]:
        """The questions of the checklist that the last run left open, each with a command that goes on."""
        if self.solved or not self.runs:
            return {}
        lacking = set(self.lacking)
        command = f"judge {'hint' if self.problem.has_hints else 'show'} {self.problem.id}"
        return {
            row.id: command
            for row in read_checklist(folders).rows
            if lacking.intersection(row.skills) or (not lacking and self.problem.id in row.katas)
        }
