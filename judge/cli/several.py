"""Several files of one problem at once, each judged in a process of its own."""

from __future__ import annotations

import atexit
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path

from msgspec import Struct

from judge.cli.submissions import Submission
from judge.judging.api import RunOptions
from judge.judging.pool import Processes, in_order
from judge.judging.session import Session
from judge.problem import Problem
from judge.problem.load import load_problem
from judge.run.result import Result, judge_fault


class _Task(Struct, frozen=True):
    """A submission, where its problem lies, and how many are judged at once."""

    submission: Submission
    folder: Path
    solutions: Path
    options: RunOptions
    had: str | None
    jobs: int


def judged_at_once(
    problem: Problem, submissions: Sequence[Submission], options: RunOptions, had: str | None, pool: Processes
) -> Iterator[Result]:
    """The results, in order. Raises JudgeError."""
    tasks = [_Task(each, problem.folder, problem.solutions, options, had, pool.count) for each in submissions]
    return in_order(
        pool, judge_one, tasks, lambda task, why: judge_fault(problem.id, task.submission.name, why)
    )


def judge_one(task: _Task) -> Result:
    """What a process does; the session stays open for its next file."""
    session = _session(task.folder, task.solutions, task.options, task.had, task.jobs)
    return session.judge(task.submission.source, task.submission.name)


@cache
def _session(folder: Path, solutions: Path, options: RunOptions, had: str | None, jobs: int) -> Session:
    session = Session(load_problem(folder, solutions), options, jobs=jobs, had=had)
    atexit.register(session.close)
    return session
