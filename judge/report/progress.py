"""A progress bar on standard error, for a person who waits: none for work that is over at once."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from judge.report.screen import is_terminal
from judge.report.words import printable

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID

Advance = Callable[[int, int], None]
Stage = Callable[[str, int, int], None]

_PATIENCE = 0.5  # seconds before a bar appears
_EACH = 0.1  # seconds between two drawings of it


class _Bar:
    """A bar that comes into being when the work turns out to be long; rich is imported only then."""

    def __init__(self, label: str) -> None:
        self._label = label
        self._begun = time.monotonic()
        self._drawn = 0.0
        self._progress: Progress | None = None
        self._task: TaskID | None = None

    def advance(self, done: int, total: int) -> None:
        """Show that `done` of `total` are done."""
        self.stage("", done, total)

    def stage(self, what: str, done: int, total: int) -> None:
        """Show that `done` of `total` are done of the part that is called `what`."""
        label = f"{self._label}: {what}" if what else self._label
        if self._progress is None or self._task is None:
            if time.monotonic() - self._begun < _PATIENCE:
                return
            if done >= total:  # it is over, and was not long; or there is nothing left to show
                return
            self._progress = _rich_progress()
            self._task = self._progress.add_task(label, total=total)
            self._progress.start()
        now = time.monotonic()
        drawn = now - self._drawn >= _EACH
        self._progress.update(self._task, description=label, completed=done, total=total, refresh=drawn)
        if drawn:
            self._drawn = now
        if done >= total:  # what comes after it may have a bar of its own
            self.close()

    def close(self) -> None:
        """Take the bar off the screen."""
        if self._progress is not None:
            self._progress.stop()
            self._progress = self._task = None


@contextmanager
def _bar(label: str) -> Iterator[_Bar | None]:
    """A bar while the block runs; None where nobody is looking."""
    if not is_terminal(sys.stderr) or os.environ.get("TERM") == "dumb":
        yield None
        return
    bar = _Bar(printable(label))
    try:
        yield bar
    finally:
        bar.close()


@contextmanager
def progress(label: str) -> Iterator[Advance | None]:
    """What to tell how many of how many are done; None where nobody is looking."""
    with _bar(label) as bar:
        yield bar.advance if bar else None


@contextmanager
def stages(label: str) -> Iterator[Stage | None]:
    """As `progress`, for work in parts: it is told the part's name first."""
    with _bar(label) as bar:
        yield bar.stage if bar else None


def _rich_progress() -> Progress:
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn

    columns = (TextColumn("{task.description}", markup=False), BarColumn(bar_width=24), MofNCompleteColumn())
    console = Console(stderr=True)
    return Progress(
        *columns,
        console=console,
        auto_refresh=False,  # in a thread of its own, which the machine may not have left
        transient=True,
        redirect_stdout=False,
        redirect_stderr=False,
    )
