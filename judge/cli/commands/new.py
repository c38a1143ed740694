"""`judge new`: a kata of one's own to begin with."""

from __future__ import annotations

from pathlib import Path

import click

from judge.cli.options import json_option, write_json
from judge.errors import ExitCode
from judge.kata.begin import begin_kata
from judge.report.kata import new_lines
from judge.report.screen import out

SCHEMA = 1


@click.command("new")
@click.argument("folder", metavar="DIR", type=click.Path(path_type=Path))
@click.argument("name", metavar="[NAME]", required=False)
@json_option
def command(folder: Path, name: str | None, as_json: bool) -> ExitCode:
    """Write a kata of your own to begin with.

    It goes into DIR/problems/NAME and DIR/solutions/NAME. If DIR is itself a folder of problems, it goes
    there. Without NAME, the kata is named after DIR. It is a small, complete kata about two points, which
    judge verify finds sound: change it file by file into yours. No file is ever overwritten.

    Exit status: 0 written, 2 usage.
    """
    begun = begin_kata(folder, name)
    files = [str(path) for path in begun.files]
    if as_json:
        found = {"problem": begun.problem.id, "problems": str(begun.problems), "files": files}
        write_json({"schema": SCHEMA, **found})
        return ExitCode.ACCEPTED
    screen = out()
    screen.show(new_lines(begun.problem, str(begun.problems), files, screen.width))
    return ExitCode.ACCEPTED
