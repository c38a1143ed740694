"""What a person who waits is told on standard error: a bar or a line; nothing for work that is soon over."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING

from judge.report.screen import Screen, err, fitted, is_terminal, note
from judge.report.words import printable

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID

Advance = Callable[[int, int], None]
Stage = Callable[[str, int, int], None]

_PATIENCE = 0.5  # seconds before a bar appears
_EACH = 0.1  # seconds between two drawings of it on a terminal
_SELDOM = 30.0  # … and between two lines of a log


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


class Live:
    """A context manager; `show` what is to be said now, `hide` it before anything else is written.

    On a terminal it is one line and leaves nothing behind. Elsewhere, into a file or a pipe, it is a line
    every half minute, without control characters; `silent` says nothing at all.
    """

    def __init__(self, *, silent: bool = False, clock: Callable[[], float] = time.monotonic) -> None:
        self._silent = silent
        self._clock = clock
        self._shown = False
        self._terminal = is_terminal(sys.stderr) and os.environ.get("TERM") != "dumb"
        self._last = -_EACH if self._terminal else clock()

    def __enter__(self) -> Live:
        return self

    def __exit__(self, *exc: object) -> None:
        self.hide()

    def show(self, text: Callable[[], str]) -> None:
        """Say this, unless something was said just now; `text` is asked only where it is said."""
        now = self._clock()
        if self._silent or now - self._last < (_EACH if self._terminal else _SELDOM):
            return
        self._last = now
        if not self._terminal:
            note(text())
            return
        screen = err()
        room = (screen.width or 80) - 1  # a line that is full goes on in the next one
        _write(screen, f"\r\x1b[K{fitted(text(), room)}")
        self._shown = True

    def hide(self) -> None:
        """Take it off the screen."""
        if self._shown:
            _write(err(), "\r\x1b[K")
            self._shown = False
            self._last = -_EACH  # it is to be back soon


def _write(screen: Screen, text: str) -> None:
    with suppress(OSError):  # nobody looks any more
        screen.write(text)
