"""Keeping what `judge run` judged in the history, without ever standing in a verdict's way."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from judge.cli.submissions import Submission
from judge.errors import HistoryError
from judge.report.screen import note
from judge.run.result import Result

if TYPE_CHECKING:
    from judge.kata.history import History


class Recording:
    """Adds results to the history; a context manager.

    The history is opened with the first result, when it has been shown. A history that fails is told of once
    and then left alone: exit status and verdicts are what they would be without it.
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

    def add(self, submission: Submission, result: Result) -> None:
        """Keep one result."""
        if not self._wanted:
            return
        from judge.kata.history import History

        try:
            if self._history is None:
                self._history = History.open(self._path)
            self._history.add(result, submission.source, _absolute(submission.name))
        except HistoryError as fault:
            self._wanted = False
            note(f"not kept in the history: {fault}")


def _absolute(name: str) -> str:
    """The file from the root, or nothing where there will be no such file tomorrow: a pipe."""
    path = Path(name)
    try:
        return str(path.absolute()) if path.is_file() else ""
    except OSError:  # the current folder is gone
        return ""
