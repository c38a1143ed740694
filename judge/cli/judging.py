"""Judging submissions as a person has asked for it: the one way of `judge run` and `judge watch`."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from pathlib import Path

from msgspec import Struct

from judge.cli.picture import Drawing
from judge.cli.recording import Recording
from judge.cli.regression import save_regression
from judge.cli.submissions import Submission
from judge.errors import UsageError
from judge.judging.executors import executor
from judge.judging.job import Terms
from judge.judging.session import Session
from judge.language import is_program
from judge.problem import Problem
from judge.problem.find import find_problem
from judge.report.progress import progress
from judge.report.screen import Notes
from judge.run.execute import judge_fault
from judge.run.result import Result


class Wish(Struct, frozen=True):
    """How submissions are to be judged, and what is to be done about those that fail."""

    terms: Terms
    jobs: int = 1
    regression: Path | None = None
    kept: bool = True  # in the history
    db: Path | None = None


def judged(problem: Problem, submissions: Sequence[Submission], wish: Wish) -> Generator[Drawing, None, None]:
    """Judge them; each result is kept in the history once the caller has done with it and asks for more.

    Close it, so that it is kept as well where the caller fails. Raises JudgeError.
    """

    def lost(submission: Submission, why: str) -> Result:
        return judge_fault(problem.id, submission.name, why)

    said = Notes()
    with (
        Session(problem, wish.terms, jobs=wish.jobs, expected=len(submissions), bars=progress) as session,
        Recording(wish.db, wanted=wish.kept) as recording,
    ):
        session.boot(submissions[0].source, submissions[0].name)
        said.say(session.data.notes)
        results = executor(wish.jobs).results(
            lambda submission: session.judge(submission.source, submission.name), submissions, lost
        )
        for submission, result in zip(submissions, results, strict=True):
            said.say(result.notes)
            if wish.regression is not None:
                said.say(save_regression(wish.regression, session.data, result))
            try:
                yield Drawing(problem, session.data, result)
            finally:  # the verdict comes first; where nobody reads it, the run is kept all the same
                recording.add(submission, result)


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
