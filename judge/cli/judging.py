"""Judging submissions as a person has asked for it: once, or a file under watch.

A file is watched for its saves, however an editor does that: in place, truncated first, or renamed. To look
costs next to nothing, on any file system and through links.

Containers are started as early as can be: most of what judging and showing need is imported while they boot.
"""

from __future__ import annotations

import atexit
import time
from collections.abc import Callable, Generator, Sequence
from contextlib import AbstractContextManager, suppress
from functools import cache, partial
from importlib import import_module
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from judge.cli.files import SubmissionFile, read_submission
from judge.cli.options import Common
from judge.cli.resolve import Kata, history_at, this_folder
from judge.errors import JudgeError, StoreError, UsageError, told
from judge.judging import RunOptions
from judge.judging.session import Session
from judge.problem import Verdict
from judge.problem.load import load_problem
from judge.report.published_result import RunReport
from judge.report.screen import Notes, note
from judge.report.wait import Advance, Live, progress
from judge.report.words import shown_name
from judge.run.result import Result, judge_fault

_PAUSE = 0.05  # seconds in which a file that is written on would change
_PAUSES = 20  # of them at most
_PATIENCE = 6  # pauses for a file that is being replaced

SavedMark = tuple[int, int, int]  # what changes with every save: the inode, the size, the time in nanoseconds


def with_standing(found: RunReport, common: Common) -> RunReport:
    """An accepted result with what it took the person, where the history can say that."""
    if found.result.solved:
        from judge.cli.home import standing

        with suppress(JudgeError):  # the verdict is known, and worth more
            return replace(found, standing=standing(found.result.problem, common))
    return found


class Wish(Struct, frozen=True):
    """How many submissions are judged at once, and what is kept of them."""

    jobs: int = 1
    kept: bool = True  # in the history
    db: Path | None = None
    total: int = 1  # submissions, to all problems
    before: int = 0  # those among them that were judged already


def judged(
    session: Session,
    submissions: Sequence[SubmissionFile],
    wish: Wish,
    on_verdict: Callable[[Result], None] | None = None,
) -> Generator[RunReport, None, None]:
    """Judge them; each result is in the history before it is handed out, so that none is shown and then lost.

    `on_verdict` hears of a failure before it is explained, in place of who looks at the terminal. Close it,
    so that what was started for the rest ends. Raises JudgeError.
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

        path = this_folder() / submission.name
        place = str(path) if path.is_file() else ""  # of a pipe nothing will be there tomorrow
        with history_at(db) as history:
            history.keep(run_of(result, submission.source, place), submission.source)
    except Exception as fault:
        note(f"not kept in the history: {told(fault)}")
        return False
    return True


# -- a file under watch --------------------------------------------------------------------------------


def mark(path: Path) -> SavedMark | None:
    """The file's mark; None where there is none, or it cannot be seen."""
    try:
        found = path.stat()
    except (OSError, ValueError):
        return None
    return found.st_ino, found.st_size, found.st_mtime_ns


def settled(path: Path) -> SavedMark | None:
    """The file's mark once it has stopped changing; a missing or empty one is given time to come back."""
    before = mark(path)
    for pauses in range(1, _PAUSES + 1):
        time.sleep(_PAUSE)
        now = mark(path)
        if now == before and ((now and now[1]) or pauses >= _PATIENCE):
            break
        before = now
    return before


class WatchedFile:
    """A kata under watch: whether its file was saved since it was judged, and judging it.

    What can be kept from one save to the next is, the data and the reference's box. Close it, so that the box
    ends.
    """

    def __init__(self, kata: Kata, common: Common, level: str | None = None) -> None:
        self._kata = kata
        self._options, self._db = RunOptions(isolation=common.isolation, level=level), common.db
        self._seen: SavedMark | str | None = "not looked at yet"
        self._session: Session | None = None
        self._had: str | None = None  # the level of isolation so far

    @property
    def changed(self) -> bool:
        """Whether the file is another one than the last that was seen."""
        return mark(self._kata.path) != self._seen

    def saved(self) -> bool:
        """Whether there is something new to judge or to tell; waits while the file is being written."""
        if not self.changed:
            return False
        before, self._seen = self._seen, settled(self._kata.path)
        return self._seen != before

    def judge(self, on_verdict: Callable[[Result], None] | None = None) -> RunReport | str:
        """Judge the file as it is now, as `judge run` does; a sentence where that cannot be done.

        `on_verdict` hears of a failure before it is explained.

        Raises:
            UsageError: the isolation that was demanded cannot be had.
        """
        name = self._kata.name
        if self._seen is None:
            return f"{name} is gone; it is judged again when it is back"
        try:
            submission = read_submission(name)
        except UsageError as fault:
            return str(fault)
        if not submission.source.strip():
            return f"{name} is empty; it is judged when there is something in it"
        clean = False
        try:
            if self._session is None:
                self._session = Session(self._kata.problem, self._options, had=self._had)
            (found,) = judged(self._session, [submission], Wish(db=self._db), on_verdict)
            if found.result.verdict is not Verdict.JE:  # that one was held nowhere
                self._had = found.result.isolation or self._had
                clean = True
            return found
        except UsageError:
            raise
        except JudgeError as fault:
            return str(fault)
        finally:
            if not clean:  # whatever was raised, and a verdict that says nothing of it, ends what was kept
                self.close()

    def close(self) -> None:
        """End what was kept; judging goes on without."""
        session, self._session = self._session, None
        if session is not None:
            session.close()
