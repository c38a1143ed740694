"""How far a person has come on each level of the katas that have levels."""

from __future__ import annotations

from collections.abc import Iterable
from datetime import datetime

from msgspec import Struct
from msgspec.structs import replace

from judge.kata.events import Run
from judge.problem import Problem
from judge.problem.model import KataLevel


class LevelStanding(Struct, frozen=True):
    """One level of a problem: the most of its `groups` that one run passed, and when one first passed all."""

    problem: str
    level: KataLevel
    groups: int
    best: int = 0
    since: datetime | None = None


def level_standings(problems: Iterable[Problem], runs: Iterable[Run]) -> list[LevelStanding]:
    """Every level of these problems after these runs, which are in their order; the easier level first."""
    runs = [run for run in runs if run.counts]
    found = []
    for problem in problems:
        passed = [(run.when, set(run.passed)) for run in runs if run.problem == problem.id]
        for level in problem.levels:
            names = {group.name for group in problem.of_level(level)}
            standing = LevelStanding(problem.id, level, len(names))
            for when, groups in passed:
                standing = _after(standing, len(names & groups), when)
            found.append(standing)
    return found


def _after(standing: LevelStanding, passed: int, when: datetime) -> LevelStanding:
    """The standing once a run that passed so many of the level's groups is done."""
    since = standing.since or (when if passed == standing.groups else None)
    return replace(standing, best=max(standing.best, passed), since=since)
