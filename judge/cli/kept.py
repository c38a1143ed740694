"""The history as commands use it: what is damaged is said once, and it never stands in a verdict's way."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import click

from judge.errors import told
from judge.report.screen import note

if TYPE_CHECKING:
    from judge.cli.submissions import Submission
    from judge.practice.history import History
    from judge.run.result import Result


@contextmanager
def history_at(path: Path | None, *, reading: bool = False) -> Iterator[History]:
    """As `History.open`; afterwards a note says what was left out or set aside."""
    from judge.practice.history import History

    with History.open(path, reading=reading) as history:
        try:
            yield history
        finally:
            _tell(history)


def _tell(history: History) -> None:
    """Say what was left out or set aside; each once a command."""
    context = click.get_current_context(silent=True)
    said: set[object] = set() if context is None else context.meta.setdefault(__name__, set())
    found = history.left_out - said
    said |= history.left_out
    if found:
        what = "1 damaged row is" if len(found) == 1 else f"{len(found)} damaged rows are"
        note(f"{what} left out of the history")
    if history.set_aside is not None:
        from judge.report.words import shown_name  # only for the one who is told

        name = shown_name(str(history.set_aside))
        note(f"the history was damaged: it is kept as {name}, and a new one is begun")


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
            _tell(self._history)

    def open(self) -> None:
        """Open the history, which takes longer than all that is added to it."""
        if self._wanted:
            from judge.practice.history import History

            with self._spared():
                self._history = History.open(self._path)

    def add(self, submission: Submission, result: Result) -> None:
        """Keep one result; it is committed when this returns."""
        if not self._wanted:
            return
        from judge.practice.history import run_of

        with self._spared():
            if self._history is not None:
                run = run_of(result, submission.source, _absolute(submission.name))
                self._history.keep(run, submission.source)

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
