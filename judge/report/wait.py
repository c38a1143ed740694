"""What a person who waits is told on standard error: a bar or a line; nothing for work that is soon over."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, suppress
from functools import partial
from time import monotonic

from judge.report.screen import Screen, draws, err, fitted, note

Advance = Callable[[int, int], None]
Stage = Callable[[str, int, int], None]

_PATIENCE = 0.5  # seconds before a bar appears
_EACH = 0.1  # seconds between two drawings of it on a terminal
_SELDOM = 30.0  # … and between two lines of a log
_BAR = 24


@contextmanager
def stages(label: str) -> Iterator[Stage | None]:
    """What to tell how many of how many are done of a part of the work, by the part's name.

    A bar is shown while the block runs long; None where nobody is looking.
    """
    begun = monotonic()

    def stage(what: str, done: int, total: int) -> None:
        if done >= total:  # what comes after it may have a bar of its own
            live.hide()
        elif monotonic() - begun >= _PATIENCE:
            bar = f"[{'#' * (_BAR * done // total):.<{_BAR}}] {done}/{total}"
            live.show(lambda: f"{bar}  {label}{f': {what}' if what else ''}")

    with Live() as live:
        yield stage if live.terminal else None


@contextmanager
def progress(label: str) -> Iterator[Advance | None]:
    """As `stages`, for work in one part."""
    with stages(label) as stage:
        yield partial(stage, "") if stage else None


class Live(AbstractContextManager["Live"]):
    """A context manager; `show` what is to be said now, `hide` it before anything else is written.

    On a terminal it is one line and leaves nothing behind. Elsewhere, into a file or a pipe, it is a line
    every half minute, without control characters.
    """

    def __init__(self) -> None:
        self.terminal = draws(err())
        self._shown = False
        self._last = -_EACH if self.terminal else monotonic()

    def __exit__(self, *_: object) -> None:
        self.hide()

    def show(self, text: Callable[[], str]) -> None:
        """Say this, unless something was said just now; `text` is asked only where it is said."""
        now = monotonic()
        if now - self._last < (_EACH if self.terminal else _SELDOM):
            return
        self._last = now
        if not self.terminal:
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
