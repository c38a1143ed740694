"""Judging from Python: one submission, or a job that came from another process or machine."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from judge.errors import JudgeError, UsageError
from judge.files import read_ordinary
from judge.judging import Job, RunOptions, version_of
from judge.languages import file_name, is_program
from judge.problem import Problem
from judge.problem.find import find_problem
from judge.problem.load import load_problem
from judge.run.result import Result

_NAMELESS = file_name("submission")


def judge(
    problem: str | Problem,
    source: bytes | str | os.PathLike[str],
    *,
    name: str | None = None,
    folders: Sequence[str | os.PathLike[str]] = (),
    options: RunOptions = RunOptions(),  # noqa: B008 - frozen
) -> Result:
    """Judge a submission as `judge run` does, contained; nothing is printed and nothing kept in a history.

    Args:
        problem: its name, looked up as by the command line and first in these `folders`.
        source: the submission: its text or bytes, or a `pathlib.Path` to its file.
        name: the file's name in tracebacks and in the result; a path's own by default.
        options: how to judge.

    Returns:
        The result. `result.verdict`, `score`, `groups`, `failure`, `counterexample`, `pitfall` and `time` say
        what `judge run` shows, `as_json()` is the object that it writes, and `notes` are its remarks. A fault
        of the problem or of the judge while judging is the verdict JE.

    Raises:
        UsageError: there is no such problem, group, level, file or isolation.
        ProblemError: the problem's folder is broken.
    """
    found = find_problem(problem, [Path(each) for each in folders]) if isinstance(problem, str) else problem
    options.chosen(found)  # a name that is none is told before anything is built
    content, called = read_source(source)
    return _judged(found, options, content, name or called)


def run(job: Job) -> Result:
    """Do a job, wherever this is: both it and its result can be pickled.

    Raises:
        UsageError: the isolation that it demands cannot be had.
        JudgeError: the problem here is not the one that the job was made for.
    """
    problem = load_problem(Path(job.folder), Path(job.solutions))
    if version_of(problem) != job.version:
        what = f"{job.problem} is not the problem that this job was made for"
        raise JudgeError(what, where=job.folder, remedy="bring the judge and its problems to one version")
    return _judged(problem, job.options, job.source, job.name)


def _judged(problem: Problem, options: RunOptions, source: bytes, name: str) -> Result:
    from judge.judging.session import Session  # which knows of options

    with Session(problem, options) as session:
        session.boot(source, name)
        session.prepare()
        return session.judge(source, name)


def read_source(source: bytes | str | os.PathLike[str]) -> tuple[bytes, str]:
    """The bytes of a submission, and what it is called."""
    if isinstance(source, str) and "\n" not in source and is_program(source):
        remedy = f"give pathlib.Path({source!r}), or the text that is in it"
        raise UsageError(f"{source!r} is a file's name, not a program", remedy=remedy)
    if isinstance(source, bytes | str):
        return source if isinstance(source, bytes) else source.encode(), _NAMELESS
    try:
        return read_ordinary(Path(source)), os.fspath(source)
    except OSError as fault:
        reason = (fault.strerror or "cannot be read").lower()
        raise UsageError(f"cannot be read ({reason})", where=os.fspath(source)) from fault
