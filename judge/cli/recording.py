"""Keeping what `judge run` judged in the history, without ever standing in a verdict's way."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from judge.cli.submissions import Submission
from judge.errors import told
from judge.report.screen import note
from judge.run.result import Result

if TYPE_CHECKING:
    from judge.kata.history import History


class Recording:
    """Adds results to the history; a context manager.

    A result is added before it is shown: whoever has seen it finds it there, even if the judge is killed at
    that moment. A commit hands it to the system, which outlives the judge (see `judge.database`).

    A history that fails gets one note and is then left alone: exit status and verdicts are what they would be
    without it.
    """

    def __init__(self, path: Path | None, *, wanted: bool = True) -> None:
        self._path = path
        self._wanted = wanted
        self._history: History | None = None

    def __enter__(self) -> Recording:
        return self

    def __exit__(self, *exc: object) -> None:
        if self._history is not None:
            self._history.__exit__(*exc)

    def open(self) -> None:
        """Open the history, which takes longer than all that is added to it."""
        if self._wanted:
            from judge.kata.history import History

            with self._spared():
                self._history = History.open(self._path)

    def add(self, submission: Submission, result: Result) -> None:
        """Keep one result; it is committed when this returns."""
        if self._history is not None and self._wanted:
            with self._spared():
                self._history.add(result, submission.source, _absolute(submission.name))

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
