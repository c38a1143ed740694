"""Judging submissions as a person has asked for it: the one way of `judge run` and `judge start`.

Containers are started as early as can be: most of what judging and showing need is imported while they boot.
"""

from __future__ import annotations

import atexit
from collections.abc import Callable, Generator, Sequence
from contextlib import AbstractContextManager, suppress
from functools import cache, partial
from importlib import import_module
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from judge.cli.files import SubmissionFile
from judge.cli.options import Common
from judge.cli.resolve import history_at
from judge.errors import JudgeError, StoreError, told
from judge.judging.options import RunOptions
from judge.judging.session import Session
from judge.problem import Problem
from judge.problem.load import load_problem
from judge.report.published_result import RunReport
from judge.report.screen import Notes, note
from judge.report.wait import Advance, Live, progress
from judge.report.words import shown_name
from judge.run.result import Result, judge_fault


def with_standing(found: RunReport, common: Common) -> RunReport:
    """An accepted result with what it took the person, where the history can say that."""
    if found.result.solved:
        from judge.cli.home import standing

        with suppress(JudgeError):  # the verdict is known, and worth more
            return replace(found, standing=standing(found.result.problem, common))
    return found


class Wish(Struct, frozen=True):
    """How submissions are to be judged, and what is kept of them."""

    options: RunOptions
    jobs: int = 1
    kept: bool = True  # in the history
    db: Path | None = None
    total: int = 1  # submissions, to all problems
    before: int = 0  # those among them that were judged already


def judged(
    problem: Problem, submissions: Sequence[SubmissionFile], wish: Wish
) -> Generator[RunReport, None, None]:
    """Judge them; each result is in the history before it is handed out, so that none is shown and then lost.

    Close it, so that what was started for the rest ends. Raises JudgeError.
    """
    with Session(problem, wish.options) as session:
        yield from judged_by(session, submissions, wish)


def judged_by(
    session: Session,
    submissions: Sequence[SubmissionFile],
    wish: Wish,
    on_verdict: Callable[[Result], None] | None = None,
) -> Generator[RunReport, None, None]:
    """As `judged`, by a session that is open; `on_verdict` hears of a failure before it is explained, in
    place of who looks at the terminal.
    """

    def numbered(label: str) -> AbstractContextManager[Advance | None]:
        return progress(f"{done + 1} of {wish.total}: {label}")

    done, said, jobs = wish.before, Notes(), min(wish.jobs, len(submissions))
    session.bars = numbered if wish.total > 1 else progress
    if jobs == 1:
        session.boot(submissions[0].source, submissions[0].name)
    if keeps := wish.kept:
        with suppress(StoreError):  # which is said with the first result
            import_module("judge.practice.history")  # while the box boots
    if jobs > 1:
        from judge.judging.pool import Processes, in_order  # most runs are of one file

        problem, pool = session.problem, Processes(jobs)
        work = partial(_judge_one, problem.folder, problem.solutions, session.options, pool.count)
        results = in_order(pool, work, submissions, lambda each, why: judge_fault(problem.id, each.name, why))
        said.say(filter(None, [pool.short]))
    else:
        session.prepare()
        results = (_judge(session, each, on_verdict) for each in submissions)
    said.say(session.data.notes)
    for submission, result in zip(submissions, results, strict=True):
        # Before it is shown: whoever has seen it finds it there, even if the judge is killed at that moment.
        keeps = keeps and _kept(result, submission, wish.db)
        said.say(result.notes)
        done += 1
        yield RunReport(result, submission.source, session.data)


def _judge(
    session: Session, submission: SubmissionFile, on_verdict: Callable[[Result], None] | None
) -> Result:
    with Live() as live:

        def show(result: Result) -> None:
            if live.terminal and session.options.diagnosed:
                from judge.report.tell import looking  # only where somebody waits

                verdict = f"{result.verdict.value}  {shown_name(result.submission)}"
                live.show(lambda: f"{verdict}  {looking(result)}")

        return session.judge(submission.source, submission.name, on_verdict or show)


def _judge_one(
    folder: Path, solutions: Path, options: RunOptions, jobs: int, submission: SubmissionFile
) -> Result:
    """What a process does; the session stays open for its next file."""
    return _session(folder, solutions, options, jobs).judge(submission.source, submission.name)


@cache
def _session(folder: Path, solutions: Path, options: RunOptions, jobs: int) -> Session:
    session = Session(load_problem(folder, solutions), options, jobs=jobs)
    atexit.register(session.close)
    return session


def _kept(result: Result, submission: SubmissionFile, db: Path | None) -> bool:
    """Keep the result in the history; where that fails it is said, and exit status and verdicts stay.

    A commit hands it to the system, which outlives the judge (see `judge.database`).
    """
    try:
        from judge.practice.history import run_of

        with history_at(db) as history:
            history.keep(run_of(result, submission.source, _absolute(submission.name)), submission.source)
    except Exception as fault:
        note(f"not kept in the history: {told(fault)}")
        return False
    return True


def _absolute(name: str) -> str:
    """The file from the root, or nothing where there will be no such file tomorrow: a pipe."""
    path = Path(name)
    try:
        return str(path.absolute()) if path.is_file() else ""
    except OSError:  # the current folder is gone
        return ""
