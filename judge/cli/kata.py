"""The current kata, under the names by which some commands still ask for it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from judge.cli.resolve import here, problem_of, shown
from judge.cli.watching import Kata
from judge.kata.stub import write_stub
from judge.problem import Problem
from judge.problem.find import find_problem
from judge.report.layout import Style
from judge.report.screen import note

if TYPE_CHECKING:
    from judge.kata.events import Started
    from judge.kata.progress import Standing
    from judge.kata.sets import PracticeSet

__all__ = ["Kata", "file_in_hand", "kata_in_hand", "problem_in_hand", "problem_of", "shown", "write_stub"]

kata_in_hand = here


def file_in_hand(db: Path | None) -> tuple[Started, str]:
    """The current kata of this folder, and its file as a person would name it. Raises UsageError."""
    current = here(db)
    return current, shown(current.path)


def problem_in_hand(name: str | None, folders: Sequence[Path], db: Path | None) -> Problem:
    """The problem of that name; where none is named, the current one. Raises JudgeError."""
    return problem_of(here(db), folders) if name is None else find_problem(name, folders)


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
