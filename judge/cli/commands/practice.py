"""`judge practice`: go through a set of katas in order."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import click
from msgspec import Struct

from judge.cli.kata import folder_to_keep, shown, tell_faults, write_stub
from judge.cli.kept import history_at
from judge.cli.options import db_option, json_option, problems_option, write_json
from judge.errors import ExitCode
from judge.kata.history import Current, History
from judge.kata.sets import USUAL, PracticeSet, find_set
from judge.kata.standing import Standing, State, standings
from judge.kata.stub import file_name
from judge.problem import Problem
from judge.report.kata import writing_lines
from judge.report.practice import all_passed_lines, next_lines, practice_lines
from judge.report.screen import out

SCHEMA = 1
_NEXT = "judge run"  # without arguments: the kata in hand


class _Kata(Struct, frozen=True):
    """The kata in hand: its file, as seen from here, and whether that was written just now."""

    current: Current
    file: str
    made: bool


@click.command("practice")
@click.argument("name", metavar="[SET]", default=USUAL)
@json_option
@db_option
@problems_option
def command(name: str, as_json: bool, db: Path | None, folders: tuple[Path, ...]) -> ExitCode:
    """Go through a set of katas in order.

    Shows how each kata of the set stands and takes up the first that is not passed, unless one of them is in
    hand already. Its file is PROBLEM.py in the current folder; if it is not there it is begun as 'judge init'
    does, which is said before it is written. Nothing is ever taken up by itself: run this again for the next
    kata.

    The sets are first-steps, junior, middle, senior, professional and path, which is all of them and the
    usual one.
    """
    chosen = find_set(name, folders)
    tell_faults(chosen)

    def tell(problem: Problem, file: str) -> None:
        if not as_json:
            screen.show(writing_lines(problem, file, screen.width))

    screen = out()
    with history_at(db) as history:
        found = standings(history.runs())
        kata = _taken_up(history, chosen.problems, found, tell)
    katas = [(problem, found.get(problem.id, Standing())) for problem in chosen.problems]
    if as_json:
        write_json(_as_object(chosen, katas, kata))
        return ExitCode.ACCEPTED
    in_hand = kata.current.problem if kata else None
    screen.show(practice_lines(chosen, katas, in_hand, screen.width))
    if kata is None:
        screen.show(all_passed_lines(screen.width))
    else:
        screen.show(next_lines(kata.current.problem, kata.file, _NEXT, made=kata.made, width=screen.width))
    return ExitCode.ACCEPTED


def _taken_up(
    history: History,
    problems: Sequence[Problem],
    found: Mapping[str, Standing],
    tell: Callable[[Problem, str], None],
) -> _Kata | None:
    """The kata in hand from now on, with a file; None where all are passed.

    `tell` hears of a file that is about to be written.
    """
    opened = [problem for problem in problems if found.get(problem.id, Standing()).state is not State.PASSED]
    if not opened:
        return None
    current = history.current()
    problem = next((each for each in opened if current and each.id == current.problem), opened[0])
    known = current is not None and current.problem == problem.id
    path = Path(current.path) if current and known else Path(file_name(problem)).absolute()
    made = not path.exists()
    if made:
        tell(problem, shown(path))
        write_stub(problem, path)
    if not known:
        history.take_up(problem.id, str(path), folder_to_keep(problem))
    return _Kata(Current(problem.id, str(path)), shown(path), made)


def _as_object(
    chosen: PracticeSet, katas: Sequence[tuple[Problem, Standing]], kata: _Kata | None
) -> dict[str, Any]:
    """The published object; `current` and `next` are null where all is passed."""
    return {
        "schema": SCHEMA,
        "set": chosen.name,
        "title": chosen.title,
        "about": chosen.about,
        "problems": [_standing(problem, standing) for problem, standing in katas],
        "current": {"problem": kata.current.problem, "file": kata.file, "new": kata.made} if kata else None,
        "next": _NEXT if kata else None,
    }


def _standing(problem: Problem, standing: Standing) -> dict[str, Any]:
    return {
        "problem": problem.id,
        "title": problem.title,
        "tier": problem.tier.value,
        "state": standing.state.value,
        "attempts": standing.attempts,
        "best": standing.best,
        "passed": standing.passed.isoformat() if standing.passed else None,
        "last": standing.last.isoformat() if standing.last else None,
    }
