"""Keeping what `judge run` judged in the history, without ever standing in a verdict's way."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from judge.cli.submissions import Submission
from judge.errors import HistoryError, told
from judge.report.screen import note
from judge.run.result import Result

if TYPE_CHECKING:
    from judge.kata.history import History


class Recording:
    """Adds results to the history; a context manager.

    A result is added before it is shown: whoever has seen it finds it there, even if the judge is killed at
    that moment. A commit hands it to the system, which outlives the judge (see `judge.database`).

    A history that fails gets one note and is then left alone: exit status and verdicts are what they would be
    without it. One that another program locks for long costs nothing either: the runs are kept beside it.
    """

    def __init__(self, path: Path | None, *, wanted: bool = True) -> None:
        self._path = path
        self._wanted = wanted
        self._history: History | None = None
        self._locked: HistoryError | None = None  # who could not open it, keeps everything beside it

    def __enter__(self) -> Recording:
        return self

    def __exit__(self, *exc: object) -> None:
        if self._history is not None:
            from judge.cli.kept import tell

            self._history.__exit__(*exc)
            tell(self._history)

    def open(self) -> None:
        """Open the history, which takes longer than all that is added to it."""
        if self._wanted:
            from judge.kata.history import History

            with self._spared():
                try:
                    self._history = History.open(self._path)
                except HistoryError as fault:
                    self._lock(fault)

    def add(self, submission: Submission, result: Result) -> None:
        """Keep one result; it is committed when this returns."""
        if not self._wanted:
            return
        path = _absolute(submission.name)
        with self._spared():
            if self._locked is not None:
                from judge.kata.history import add_beside

                add_beside(self._path, result, submission.source, path, self._locked)
            elif self._history is not None and not self._history.add(result, submission.source, path):
                self._lock(HistoryError("another program is writing to the history"))

    def _lock(self, fault: HistoryError) -> None:
        """Keep what is to come beside the history. Raises the fault where it is another one than a lock."""
        from judge.database import is_busy

        self._locked = fault
        if self._history is None:  # else it is said at the end
            if not is_busy(fault):
                raise fault
            from judge.cli.kept import LOCKED

            note(LOCKED)

    @contextmanager
    def _spared(self) -> Iterator[None]:
        """Whatever goes wrong within: a result is still to be shown."""
        try:
            yield
        except Exception as fault:
            self._wanted = False
            note(f"not kept in the history: {told(fault)}")


def _absolute(name: str) -> str:
    """The file from the root, or nothing where there will be no such file tomorrow: a pipe."""
    path = Path(name)
    try:
        return str(path.absolute()) if path.is_file() else ""
    except OSError:  # the current folder is gone
        return ""
