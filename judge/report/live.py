"""A line that says how far long work is: written over again on a terminal, now and then into a log."""

from __future__ import annotations

import contextlib
import os
import sys
import time
from collections.abc import Callable

from judge.report.screen import Screen, err, fitted, is_terminal, note

_EACH = 0.1  # seconds between two states of it on a terminal
_SELDOM = 30.0  # … and between two lines of a log


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
    with contextlib.suppress(OSError):  # nobody looks any more
        screen.write(text)
