"""The kata in hand: what commands without a problem or a file are about."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.errors import UsageError
from judge.report.kata import Stage
from judge.spec import Problem, Tier
from judge.spec.find import all_problems, find_problem

if TYPE_CHECKING:
    from judge.kata.history import Current


def kata_in_hand(db: Path | None) -> Current:
    """The kata that was taken up last; its file need not be there. Raises UsageError if there is none."""
    from judge.kata.history import History

    with History.open(db, reading=True) as history:
        current = history.current()
    if current is None:
        remedy = "begin one with 'judge init PROBLEM', or name a problem and a file"
        raise UsageError("there is no kata in hand", remedy=remedy)
    return current


def file_in_hand(db: Path | None) -> tuple[str, str]:
    """The problem of the kata in hand and its file, as a person would name it from here.

    Raises:
        UsageError: there is no kata in hand, or its file is gone.
    """
    current = kata_in_hand(db)
    name = shown(current.path)
    if not Path(current.path).exists():
        what = f"the file of the kata in hand, {current.problem}, is gone"
        remedy = f"'judge init {current.problem}' begins it anew"
        raise UsageError(what, where=name, remedy=remedy)
    return current.problem, name


def problem_in_hand(name: str | None, folders: Sequence[Path], db: Path | None) -> Problem:
    """The problem of that name; where none is named, that of the kata in hand. Raises UsageError."""
    return find_problem(kata_in_hand(db).problem if name is None else name, folders)


def path_problems(folders: Sequence[Path]) -> list[Problem]:
    """The problems in the order in which they are best learned."""
    tiers = list(Tier)
    return sorted(all_problems(folders), key=lambda problem: (tiers.index(problem.tier), problem.id))


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
    from judge.kata.history import History

    with History.open(db) as history:
        history.take_up(kata.problem.id, str(kata.path))


def next_problem(after: str, folders: Sequence[Path], db: Path | None) -> Problem | None:
    """The problem of the path that comes after that one and is not solved; failing that, the first unsolved.

    None where all others are solved.
    """
    stages = path_stages(folders, db)
    names = [stage.problem.id for stage in stages]
    at = names.index(after) + 1 if after in names else 0
    return next(
        (s.problem for s in [*stages[at:], *stages[:at]] if not s.solved and s.problem.id != after), None
    )


def path_stages(folders: Sequence[Path], db: Path | None) -> list[Stage]:
    """The problems of the path in order, and how far the person has come with each."""
    from judge.kata.history import History

    with History.open(db, reading=True) as history:
        current = history.current()
        runs = history.runs()
    stages = []
    for problem in path_problems(folders):
        own = [run for run in runs if run.problem == problem.id]
        best = max((run.score for run in own), default=None)
        in_hand = current is not None and current.problem == problem.id
        stages.append(Stage(problem, best, any(run.solved for run in own), in_hand))
    return stages


def shown(path: str | Path) -> str:
    """An absolute path as a person in the current folder would write it."""
    try:
        return str(Path(path).relative_to(Path.cwd()))
    except (ValueError, OSError):  # it is elsewhere, or the current folder is gone
        return str(path)
