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

    It goes into DIR/problems/NAME and DIR/solutions/NAME; a DIR that is itself a folder of problems is taken
    as that. NAME is that of DIR where you give none. The kata is whole, a small one about two points, and
    judge verify finds it sound: change it file by file into yours. Nothing is ever written over.

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
