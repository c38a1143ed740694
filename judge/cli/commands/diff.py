"""`judge diff`: what changed from one run to another."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from judge.cli.commands.history import as_object as run_object
from judge.cli.kept import history_at
from judge.cli.options import db_option, json_option, write_json
from judge.errors import ExitCode
from judge.kata.changes import Change, change
from judge.report.history import change_lines
from judge.report.screen import out

SCHEMA = 1


@click.command("diff")
@click.argument("old", metavar="RUN", type=int)
@click.argument("new", metavar="RUN", type=int)
@json_option
@db_option
def command(old: int, new: int, as_json: bool, db: Path | None) -> ExitCode:
    """Show what changed from one run to another.

    What became of verdict, points, mistake, time and test groups, and the difference of the two sources. The
    numbers of the runs are those of 'judge history'.
    """
    with history_at(db, reading=True) as history:
        found = change(history.run(old), history.run(new), (history.source(old), history.source(new)))
    if as_json:
        write_json(as_object(found))
        return ExitCode.ACCEPTED
    screen = out()
    screen.show(change_lines(found, screen.width))
    return ExitCode.ACCEPTED


def as_object(found: Change) -> dict[str, Any]:
    """The published object; `diff` is the text of a unified diff, null where the sources are too long."""
    return {
        "schema": SCHEMA,
        "old": run_object(found.old),
        "new": run_object(found.new),
        "gained": list(found.gained),
        "lost": list(found.lost),
        "same_source": found.same_source,
        "diff": None if found.diff is None else "".join(f"{line}\n" for line in found.diff),
    }
