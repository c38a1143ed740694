"""The kata in hand: what commands without a problem or a file are about."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.atomic import new_file, replace_file
from judge.errors import UsageError
from judge.languages import language_of
from judge.problem import Problem
from judge.problem.find import find_problem, shipped_problems
from judge.report.layout import Style
from judge.report.screen import note

if TYPE_CHECKING:
    from judge.kata.events import Started
    from judge.kata.progress import Standing
    from judge.kata.sets import PracticeSet


def kata_in_hand(db: Path | None) -> Started:
    """The kata that was taken up last; its file need not be there. Raises UsageError if there is none."""
    from judge.cli.kept import history_at

    with history_at(db, reading=True) as history:
        current = history.current()
    if current is None:
        remedy = "begin one with 'judge init PROBLEM', or name a problem and a file"
        raise UsageError("there is no kata in hand", remedy=remedy)
    return current


def file_in_hand(db: Path | None) -> tuple[Started, str]:
    """The kata in hand, and its file as a person would name it from here.

    Raises:
        UsageError: there is no kata in hand, or its file is gone.
    """
    current = kata_in_hand(db)
    name = shown(current.path)
    if not Path(current.path).exists():
        what = f"the file of the kata in hand, {current.problem}, is not there"
        remedy = f"'judge init {current.problem}' begins it"
        raise UsageError(what, where=name, remedy=remedy)
    return current, name


def problem_in_hand(name: str | None, folders: Sequence[Path], db: Path | None) -> Problem:
    """The problem of that name; where none is named, that of the kata in hand. Raises UsageError."""
    return problem_of(kata_in_hand(db), folders) if name is None else find_problem(name, folders)


def problem_of(current: Started, folders: Sequence[Path]) -> Problem:
    """The problem of the kata in hand, which keeps the folder it was found in. Raises UsageError."""
    try:
        return find_problem(current.problem, with_folder_of(current, folders))
    except UsageError as fault:
        if not current.problems or Path(current.problems).is_dir():
            raise
        what = f"the problem of the kata in hand, {current.problem}, is not there"
        remedy = "name the folder that it is in now with --problems"
        raise UsageError(what, where=current.problems, remedy=remedy) from fault


def with_folder_of(current: Started | None, folders: Sequence[Path]) -> tuple[Path, ...]:
    """The folders to look in, the one of the kata in hand last."""
    kept = Path(current.problems) if current and current.problems else None
    return (*folders, kept) if kept is not None and kept.is_dir() else tuple(folders)


def folder_to_keep(problem: Problem) -> str:
    """Where a kata's problem must be looked for later: nothing where every judge finds it by itself."""
    folder = problem.folder.parent.absolute()
    return "" if folder == shipped_problems() else str(folder)


class Kata(Struct, frozen=True):
    """A problem and the file that is to solve it, from the root."""

    problem: Problem
    path: Path

    @property
    def name(self) -> str:
        """The file as a person would name it from here."""
        return shown(self.path)


def take_up(kata: Kata, db: Path | None) -> None:
    """Make it the kata in hand."""
    from judge.cli.kept import history_at
    from judge.kata.events import Started

    with history_at(db) as history:
        history.keep(Started(kata.problem.id, str(kata.path), folder_to_keep(kata.problem)))


def _stub(problem: Problem, path: Path) -> str:
    """The stub in the language that the file's name says; in Python where it says none."""
    from judge.kata.stub import make_stub  # only what writes one needs it

    return make_stub(problem, language_of(path))


def write_stub(problem: Problem, path: Path, *, force: bool = False) -> None:
    """Write the problem's stub; over a file that is there only with `force`.

    Raises:
        UsageError: there is a file, or none can be written there.
        ProblemError: no stub can be made of the problem.
    """
    text = _stub(problem, path).encode()
    where = str(path)
    try:
        if not path.name or path.is_dir():
            raise UsageError("this is a folder", where=where or "''", remedy="name a file in it")
        (replace_file if force else new_file)(path, text)
    except FileExistsError as fault:
        remedy = f"'judge watch {problem.id} {path}' goes on with it, --force writes over it"
        raise UsageError("the file is there already", where=where, remedy=remedy) from fault
    except FileNotFoundError as fault:
        remedy = f"make the folder {path.parent} first"
        raise UsageError("its folder does not exist", where=where, remedy=remedy) from fault
    except (OSError, ValueError) as fault:  # ValueError: a NUL in the name
        reason = (getattr(fault, "strerror", None) or str(fault)).lower()
        raise UsageError(f"cannot be written ({reason})", where=where, remedy="name another file") from fault


def next_problem(after: str, katas: Sequence[tuple[Problem, Standing]]) -> Problem | None:
    """The problem that comes after that one and is not passed; failing that, the first one of all.

    None where all others are passed.
    """
    names = [problem.id for problem, _ in katas]
    at = names.index(after) + 1 if after in names else 0
    for problem, standing in [*katas[at:], *katas[:at]]:
        if standing.passed is None and problem.id != after:
            return problem
    return None


def the_path(folders: Sequence[Path], db: Path | None) -> tuple[PracticeSet, list[tuple[Problem, Standing]]]:
    """The path: all katas in order, and how the person stands with each."""
    from judge.cli.kept import history_at
    from judge.kata.progress import Standing, standings
    from judge.kata.sets import USUAL, find_set

    path = find_set(USUAL, folders)
    with history_at(db, reading=True) as history:
        found = standings(history.runs())
    return path, [(problem, found.get(problem.id, Standing())) for problem in path.problems]


def tell_faults(chosen: PracticeSet) -> None:
    """Write a line for each problem that may be missing from the set."""
    for fault in chosen.faults:
        note(str(fault), Style.BAD)


def shown(path: str | Path) -> str:
    """An absolute path as a person in the current folder would write it."""
    try:
        return str(Path(path).relative_to(Path.cwd()))
    except (ValueError, OSError):  # it is elsewhere, or the current folder is gone
        return str(path)
