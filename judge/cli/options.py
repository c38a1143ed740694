"""Options and look-ups that several commands share."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

import click

from judge.errors import UsageError, nearest
from judge.problem import Group, Problem

F = TypeVar("F", bound=Callable[..., Any])

problems_option: Callable[[F], F] = click.option(
    "--problems",
    "folders",
    metavar="DIR",
    type=click.Path(path_type=Path),
    multiple=True,
    help="Look for problems in this folder first.",
)
json_option: Callable[[F], F] = click.option(
    "--json", "as_json", is_flag=True, help="Write JSON, one object a line, and nothing else."
)
group_option: Callable[[F], F] = click.option(
    "--group", "groups", metavar="G", multiple=True, help="Only this test group; may be given again."
)
seed_option: Callable[[F], F] = click.option(
    "--seed", type=int, metavar="N", help="Build other cases, from this seed, instead of the pinned ones."
)
db_option: Callable[[F], F] = click.option(
    "--db",
    metavar="FILE",
    type=click.Path(path_type=Path, dir_okay=False),
    help="The history's file, instead of $JUDGE_DB or the one in your data folder.",
)


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


def write_json(value: object) -> None:
    """Write one object on one line of standard output."""
    sys.stdout.write(json.dumps(value, allow_nan=False) + "\n")
    sys.stdout.flush()
