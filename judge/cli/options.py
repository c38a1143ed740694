"""Options and look-ups that several commands share."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click

from judge.problem.model import LEVELS

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
    "--group", "groups", metavar="G", multiple=True, help="Only this test group; repeatable."
)
level_option: Callable[[F], F] = click.option(
    "--level",
    "kata_level",
    metavar="|".join(LEVELS),
    type=click.Choice(LEVELS),
    help="Only the test groups of this level.",
)
seed_option: Callable[[F], F] = click.option(
    "--seed", type=int, metavar="N", help="Use other cases, made from this seed."
)
db_option: Callable[[F], F] = click.option(
    "--db",
    metavar="FILE",
    type=click.Path(path_type=Path, dir_okay=False),
    help="The history's file; by default $JUDGE_DB, or one in your data folder.",
)


def write_json(value: object) -> None:
    """Write one object on one line of standard output."""
    import json  # a person at a terminal does without

    sys.stdout.write(json.dumps(value, allow_nan=False) + "\n")
    sys.stdout.flush()
