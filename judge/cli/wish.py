"""What a person who has submissions judged asks for."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from msgspec import Struct

from judge.errors import UsageError
from judge.judging.job import RunOptions
from judge.languages import is_program
from judge.problem import Problem
from judge.problem.find import find_problem


class Wish(Struct, frozen=True):
    """How submissions are to be judged, and what is kept of them."""

    options: RunOptions
    jobs: int = 1
    had: str | None = None  # the level of isolation that the command has had before
    kept: bool = True  # in the history
    db: Path | None = None
    total: int = 1  # submissions, to all problems
    before: int = 0  # those among them that were judged already


def named_problem(name: str, folders: Sequence[Path]) -> Problem:
    """The problem of that name. Raises UsageError, which says so where the name is a file's."""
    try:
        return find_problem(name, folders)
    except UsageError as fault:
        if is_program(name):
            remedy = "the problem comes first: judge run PROBLEM FILE"
            raise UsageError(f"{name!r} is no problem's name", remedy=remedy) from fault
        if "/" in name:
            remedy = "give its id, and the folder it is in with --problems"
            raise UsageError(f"{name!r} is no problem's name", remedy=remedy) from fault
        raise
