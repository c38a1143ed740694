"""The file of a kata that is being watched: its saves, and its judging."""

from __future__ import annotations

import signal
import threading
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from judge.cli.files import Submission, read_submissions
from judge.cli.judging import Wish
from judge.cli.resolve import Kata
from judge.errors import JudgeError, UsageError
from judge.judging.session import Session
from judge.practice.saves import SavedMark, mark, settled
from judge.problem import Verdict
from judge.problem.load import load_problem, own_files

if TYPE_CHECKING:
    from judge.cli.drawings import Drawing


class Judging:
    """A context in which the main thread judges, and another may break that off as Ctrl-C does."""

    def __init__(self) -> None:
        self._idle = threading.Event()
        self._idle.set()
        self._turn = threading.Lock()  # so that no interrupt comes when judging is over
        self._outdated = False

    def __enter__(self) -> None:
        self._outdated = False
        self._idle.clear()

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> bool:
        """Judging is over; no error comes of breaking off what is out of date."""
        try:
            self._over()
        except KeyboardInterrupt:  # it came at the last moment
            self._over()
            if not self._outdated:
                raise
        return kind is KeyboardInterrupt and self._outdated

    def _over(self) -> None:
        with self._turn:
            self._idle.set()

    def break_off(self, *, outdated: bool = False) -> bool:
        """Interrupt the main thread if it is judging; whether there was something to break off."""
        with self._turn:
            if self._idle.is_set():
                return False
            self._outdated = outdated
            signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)
            return True

    def over(self, seconds: float) -> None:
        """Wait so long until nothing is being judged."""
        self._idle.wait(seconds)


class WatchedFile:
    """A kata under watch: whether its file was saved since it was judged, and judging it.

    What can be kept from one save to the next is, the data and the reference's box. Close it, so that the box
    ends.
    """

    def __init__(self, kata: Kata, wish: Wish) -> None:
        self.judging = Judging()
        self._kata, self._wish = kata, wish
        self._seen: SavedMark | None = None
        self._looked = False
        self._session: Session | None = None
        self._had: str | None = None  # the level of isolation so far
        self._problem = kata.problem
        self._files: list[tuple[str, SavedMark | None]] = []  # of the problem, as it was judged

    def look(self) -> None:
        """Something has happened to the file: give up judging what stood in it before, from any thread."""
        if mark(self._kata.path) != self._seen:
            self.judging.break_off(outdated=True)

    def saved(self) -> bool:
        """Whether there is something new to judge or to tell; waits while the file is being written."""
        if self._looked and mark(self._kata.path) == self._seen:
            return False
        now = settled(self._kata.path)
        new = not self._looked or now != self._seen
        self._seen, self._looked = now, True
        return new

    def judge(self) -> Drawing | str:
        """Judge the file as it is now, as `judge run` does; a sentence where that cannot be done.

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
            return self._judged(submission)
        except JudgeError as fault:
            if isinstance(fault, UsageError):
                raise
            return str(fault)

    def _judged(self, submission: Submission) -> Drawing:
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
            self._session.boot(submission.source, submission.name)
            from judge.cli.drawings import drawings  # while it boots

            (drawn,) = drawings(self._session, [submission], self._wish)
            if drawn.result.verdict is not Verdict.JE:  # that one was held nowhere
                self._had = drawn.result.isolation or self._had
                clean = True
        finally:
            if not clean:
                self.close()
        return drawn

    def close(self) -> None:
        """End what was kept; judging goes on without."""
        session, self._session = self._session, None
        if session is not None:
            session.close()
