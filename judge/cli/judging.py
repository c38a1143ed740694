"""Judging submissions as a person has asked for it: the one way of `judge run` and `judge start`.

Containers are started as early as can be: most of what judging and showing need is imported while they boot.
"""

from __future__ import annotations

import atexit
from collections.abc import Generator, Iterator, Sequence
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.cli.files import Submission
from judge.judging.api import RunOptions
from judge.judging.session import Session
from judge.problem import Problem
from judge.problem.load import load_problem
from judge.run.result import Result, judge_fault

if TYPE_CHECKING:
    from judge.cli.drawings import Drawing


class Wish(Struct, frozen=True):
    """How submissions are to be judged, and what is kept of them."""

    options: RunOptions
    jobs: int = 1
    kept: bool = True  # in the history
    db: Path | None = None
    total: int = 1  # submissions, to all problems
    before: int = 0  # those among them that were judged already


def judged(problem: Problem, submissions: Sequence[Submission], wish: Wish) -> Generator[Drawing, None, None]:
    """Judge them; each result is in the history before it is handed out, so that none is shown and then lost.

    Close it, so that what was started for the rest ends. Raises JudgeError.
    """
    with Session(problem, wish.options) as session:
        if min(wish.jobs, len(submissions)) == 1:
            session.boot(submissions[0].source, submissions[0].name)
        from judge.cli.drawings import drawings  # while it boots

        yield from drawings(session, submissions, wish)


def judged_at_once(
    problem: Problem, submissions: Sequence[Submission], options: RunOptions, jobs: int
) -> tuple[Iterator[Result], Sequence[str]]:
    """The results, in order, of several processes; and what to say of them. Judging raises JudgeError."""
    from judge.judging.pool import Processes, in_order  # most runs are of one file

    pool = Processes(jobs)
    work = partial(_judge_one, problem.folder, problem.solutions, options, pool.count)
    results = in_order(pool, work, submissions, lambda each, why: judge_fault(problem.id, each.name, why))
    return results, [pool.short] if pool.short else []


def _judge_one(
    folder: Path, solutions: Path, options: RunOptions, jobs: int, submission: Submission
) -> Result:
    """What a process does; the session stays open for its next file."""
    return _session(folder, solutions, options, jobs).judge(submission.source, submission.name)


@cache
def _session(folder: Path, solutions: Path, options: RunOptions, jobs: int) -> Session:
    session = Session(load_problem(folder, solutions), options, jobs=jobs)
    atexit.register(session.close)
    return session
