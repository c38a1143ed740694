"""Choosing some of a problem's test groups, by their names or by their level."""

from __future__ import annotations

from collections.abc import Sequence

from judge.errors import UsageError, nearest
from judge.problem.level import LEVELS
from judge.problem.model import Group, Problem


def chosen_groups(problem: Problem, names: Sequence[str], level: str | None = None) -> tuple[Group, ...]:
    """The problem's groups of those names, all of them where none is named; of one level if that is given.

    Raises:
        UsageError: the problem has no group of that name, no such level, or no group that is both.
    """
    known = [group.name for group in problem.groups]
    for name in names:
        if name not in known:
            meant = nearest(name, known)
            remedy = f"did you mean {meant!r}?" if meant else f"it has {', '.join(known)}"
            raise UsageError(f"{problem.id} has no group {name!r}", remedy=remedy)
    if level is not None:
        _check_level(problem, level)
    chosen = [group for group in problem.groups if not names or group.name in names]
    found = tuple(group for group in chosen if level is None or (group.level and group.level.value == level))
    if not found:
        there = ", ".join(f"{group.name} is {group.level.value}" for group in chosen if group.level)
        raise UsageError(f"no group that is named is of the {level} level", remedy=f"leave one out: {there}")
    return found


def _check_level(problem: Problem, level: str) -> None:
    if level not in LEVELS:
        raise UsageError(f"there is no level {level!r}", remedy=f"use one of {', '.join(LEVELS)}")
    if not problem.levels:
        raise UsageError(f"{problem.id} has one level only", remedy="leave the level out")
