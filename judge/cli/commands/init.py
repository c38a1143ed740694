"""`judge init`: the file a kata begins with."""

from __future__ import annotations

from pathlib import Path

import click

from judge.cli.kata import Kata, take_up, write_stub
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.errors import ExitCode
from judge.kata.stub import file_name
from judge.problem.find import find_problem
from judge.report.kata import begun_lines
from judge.report.screen import out

SCHEMA = 1


@click.command("init")
@click.argument("name", metavar="PROBLEM")
@click.argument("file", metavar="[FILE]", required=False)
@click.option("--force", is_flag=True, help="Write over a file that is there.")
@json_option
@db_option
@problems_option
def command(
    name: str, file: str | None, force: bool, as_json: bool, db: Path | None, folders: tuple[Path, ...]
) -> ExitCode:
    """Begin a kata: write the file for your solution.

    It has the signature, the statement and its examples, and fails until you have written the function. FILE
    is named after the problem where you name none. The kata is then in hand: judge run, judge watch and
    judge hint are about it until you begin another one.
    """
    problem = find_problem(name, folders)
    path = Path(file_name(problem) if file is None else file)
    write_stub(problem, path, force=force)
    take_up(Kata(problem, path.absolute()), db)
    if as_json:
        write_json({"schema": SCHEMA, "problem": problem.id, "file": str(path)})
        return ExitCode.ACCEPTED
    screen = out()
    screen.show(begun_lines(problem, str(path), screen.width))
    return ExitCode.ACCEPTED
