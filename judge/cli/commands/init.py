"""`judge init`: the file a kata begins with."""

from __future__ import annotations

import os
from pathlib import Path

import click

from judge.cli.kata import Kata, take_up
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.data.atomic import replace_file
from judge.errors import ExitCode, UsageError
from judge.kata.stub import file_name, make_stub
from judge.report.kata import begun_lines
from judge.report.screen import out
from judge.spec import Problem
from judge.spec.find import find_problem

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


def write_stub(problem: Problem, path: Path, *, force: bool = False) -> None:
    """Write the problem's stub; over a file that is there only with `force`.

    Raises:
        UsageError: there is a file, or none can be written there.
        ProblemError: no stub can be made of the problem.
    """
    text = make_stub(problem).encode()
    where = str(path)
    if not path.name or path.is_dir():
        raise UsageError("this is a folder", where=where or "''", remedy="name a file in it")
    try:
        if force:
            replace_file(path, text)
            return
        with path.open("xb") as file:  # at once: nobody else's file is lost in between
            file.write(text)
    except FileExistsError as fault:
        remedy = f"'judge watch {problem.id} {path}' goes on with it, --force writes over it"
        raise UsageError("the file is there already", where=where, remedy=remedy) from fault
    except FileNotFoundError as fault:
        remedy = f"make the folder {path.parent} first"
        raise UsageError("its folder does not exist", where=where, remedy=remedy) from fault
    except (OSError, ValueError) as fault:  # ValueError: a NUL in the name
        reason = (
            os.strerror(fault.errno).lower() if isinstance(fault, OSError) and fault.errno else str(fault)
        )
        raise UsageError(f"cannot be written ({reason})", where=where, remedy="name another file") from fault
