"""Judging submissions as a person has asked for it: the one way of `judge run` and `judge watch`.

Containers are started as early as can be: most of what judging and showing need is imported while they boot.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.cli.submissions import Submission
from judge.errors import UsageError
from judge.judging.containment import Containment
from judge.judging.job import Terms
from judge.language import is_program
from judge.problem import Problem
from judge.problem.find import find_problem

if TYPE_CHECKING:
    from judge.cli.picture import Drawing


class Wish(Struct, frozen=True):
    """How submissions are to be judged, and what is to be done about those that fail."""

    terms: Terms
    jobs: int = 1
    had: str | None = None  # the level of isolation that the command has had before
    regression: Path | None = None
    kept: bool = True  # in the history
    db: Path | None = None


def judged(problem: Problem, submissions: Sequence[Submission], wish: Wish) -> Generator[Drawing, None, None]:
    """Judge them; each result is in the history before it is handed out, so that none is shown and then lost.

    Close it, so that what was started for the rest ends. Raises JudgeError.
    """
    first, terms = submissions[0], wish.terms
    jobs = min(wish.jobs, len(submissions) * len(terms.groups or problem.groups))
    with Containment(problem, terms.isolation, jobs, wish.had) as containment:
        containment.boot(first.source, first.name)
        from judge.cli.drawings import drawings  # while it boots

        yield from drawings(problem, submissions, wish, containment)


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
