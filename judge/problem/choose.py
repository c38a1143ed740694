"""Choosing some of a problem's test groups by their names."""

from __future__ import annotations

from collections.abc import Sequence

from judge.errors import UsageError, nearest
from judge.problem.model import Group, Problem


def chosen_groups(problem: Problem, names: Sequence[str]) -> tuple[Group, ...]:
    """The problem's groups of those names, all of them where none is named.

    Raises:
        UsageError: the problem has no group of that name.
    """
    known = [group.name for group in problem.groups]
    for name in names:
        if name not in known:
            meant = nearest(name, known)
            remedy = f"did you mean {meant!r}?" if meant else f"it has {', '.join(known)}"
            raise UsageError(f"{problem.id} has no group {name!r}", remedy=remedy)
    return tuple(group for group in problem.groups if not names or group.name in names)
