"""`judge next`: the next kata of the path, when it is asked for."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from judge.cli.drilling import cards_due
from judge.cli.kata import Kata, next_problem, take_up, tell_faults, the_path, with_folder_of, write_stub
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.errors import ExitCode
from judge.kata.stub import file_name
from judge.problem import Problem
from judge.report.kata import begun_lines, finished_lines, next_lines, waiting_lines, writing_lines
from judge.report.screen import out

if TYPE_CHECKING:
    from judge.kata.events import Started

SCHEMA = 1


@click.command("next")
@click.option("--init", "writing", is_flag=True, help="Write its file at once, as judge init does.")
@json_option
@db_option
@problems_option
def command(writing: bool, as_json: bool, db: Path | None, folders: tuple[Path, ...]) -> ExitCode:
    """Go on to the next kata.

    The next kata is the next one of the path that you have not solved. It becomes your current kata, for
    judge run, judge watch and judge hint. Its file is looked for in the current folder, under the problem's
    name. Only --init writes one, and says so first.
    """
    current = _current(db)
    folders = with_folder_of(current, folders)
    path, katas = the_path(folders, db)
    tell_faults(path)
    problem = next_problem(current.problem if current else "", katas)
    screen = out()
    waiting = cards_due(db, folders)
    if problem is None:
        if as_json:
            write_json(_object(None, None, waiting))
        else:
            screen.show(finished_lines(screen.width))
            screen.show(waiting_lines(waiting, screen.width))
        return ExitCode.ACCEPTED
    name = file_name(problem)
    kata = Kata(problem, Path(name).absolute())
    if writing and not kata.path.exists():
        if not as_json:
            screen.show(writing_lines(problem, kata.name, screen.width))
        write_stub(problem, Path(name))
    take_up(kata, db)
    if as_json:
        write_json(_object(problem, kata, waiting))
        return ExitCode.ACCEPTED
    lines = (
        begun_lines(problem, kata.name, screen.width)
        if kata.path.exists()
        else next_lines(problem, screen.width)
    )
    screen.show([*lines, *waiting_lines(waiting, screen.width)])
    return ExitCode.ACCEPTED


def _current(db: Path | None) -> Started | None:
    """The kata in hand, if there is one."""
    from judge.cli.kept import history_at

    with history_at(db, reading=True) as history:
        return history.current()


def _object(problem: Problem | None, kata: Kata | None, waiting: int) -> dict[str, object]:
    """The published object; the problem is null where all are solved."""
    return {
        "schema": SCHEMA,
        "problem": problem.id if problem else None,
        "title": problem.title if problem else None,
        "tier": problem.tier.value if problem else None,
        "file": kata.name if kata else None,
        "exists": bool(kata and kata.path.exists()),
        "cards_due": waiting,
    }
