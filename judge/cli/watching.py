"""The file of a kata that is being watched: its saves, however an editor does that, and its judging.

An editor writes in place, truncates first, or renames. To look costs next to nothing, on any file system and
through links.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from judge.cli.files import SubmissionFile, read_submissions
from judge.cli.judging import Wish, judged_by
from judge.cli.options import Common
from judge.cli.resolve import Kata
from judge.errors import JudgeError, UsageError
from judge.judging.options import RunOptions
from judge.judging.session import Session
from judge.problem import Verdict
from judge.problem.load import load_problem, own_files
from judge.report.published_result import RunReport
from judge.run.result import Result

_PAUSE = 0.05  # seconds in which a file that is written on would change
_PAUSES = 20  # of them at most
_PATIENCE = 6  # pauses for a file that is being replaced

SavedMark = tuple[int, int, int]  # what changes with every save: the inode, the size, the time in nanoseconds


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
        self._wish = Wish(RunOptions(isolation=common.isolation, level=level), db=common.db)
        self._seen: SavedMark | str | None = "not looked at yet"
        self._session: Session | None = None
        self._had: str | None = None  # the level of isolation so far
        self._problem = kata.problem
        self._files: list[tuple[str, SavedMark | None]] = []  # of the problem, as it was judged

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
            submission, *_ = read_submissions([name])
        except UsageError as fault:
            return str(fault)
        if not submission.source.strip():
            return f"{name} is empty; it is judged when there is something in it"
        try:
            return self._judged(submission, on_verdict)
        except UsageError:
            raise
        except JudgeError as fault:
            return str(fault)

    def _judged(self, submission: SubmissionFile, on_verdict: Callable[[Result], None] | None) -> RunReport:
        """Judge it; whatever is raised, and a verdict that says nothing of it, ends what was kept.

        So does a change of the problem, at which a setter may be at work.
        """
        problem, clean = self._problem, False
        with suppress(OSError):  # whoever reads them says so
            files = [(path, mark(Path(path))) for path in own_files(problem.folder)]
            if files != self._files:
                self.close()
                if self._files:
                    self._problem = problem = load_problem(problem.folder, problem.solutions)
                self._files = files
        try:
            if self._session is None:
                self._session = Session(problem, self._wish.options, had=self._had)
            (judged,) = judged_by(self._session, [submission], self._wish, on_verdict)
            if judged.result.verdict is not Verdict.JE:  # that one was held nowhere
                self._had = judged.result.isolation or self._had
                clean = True
        finally:
            if not clean:
                self.close()
        return judged

    def close(self) -> None:
        """End what was kept; judging goes on without."""
        session, self._session = self._session, None
        if session is not None:
            session.close()
