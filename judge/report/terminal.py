"""A terminal that is drawn on again and again and answers single keys, and that is given back as it was."""

from __future__ import annotations

import atexit
import os
import re
import select
import threading
from collections.abc import Callable, Sequence
from contextlib import suppress
from types import TracebackType
from typing import Any

from judge.report.screen import Screen, is_terminal

_HOME = "\x1b[H"
_REST_OF_LINE = "\x1b[K"
_REST_OF_SCREEN = "\x1b[J"
_TOGETHER = ("\x1b[?2026h", "\x1b[?2026l")  # shown at once where the terminal knows how; ignored elsewhere
_SEQUENCE = re.compile(r"\x1b(\[[0-9;?]*[ -/]*[@-~]|O.|.)?")  # of an arrow, a function key, Alt and a key
GONE = ""  # told instead of a key when nobody is there any more


def draws(screen: Screen) -> bool:
    """Whether lines can be drawn over there: a terminal that obeys more than text."""
    return is_terminal(screen.stream) and os.environ.get("TERM", "dumb") != "dumb"


def redraw(screen: Screen, text: str, prompt: str) -> None:
    """Replace what is seen by `text`, whole lines, and the prompt below it: in one write, line over line.

    What is more than the screen holds scrolls out of its top, and can be scrolled back to.
    """
    rows = [f"{row}{_REST_OF_LINE}\n" for row in text.splitlines()]
    begin, end = _TOGETHER
    screen.write(f"{begin}{_HOME}{''.join(rows)}{prompt}{_REST_OF_SCREEN}{end}")


def reprompt(screen: Screen, prompt: str) -> None:
    """Replace the prompt alone."""
    screen.write(f"\r{prompt}{_REST_OF_SCREEN}")


class Keys:
    """Tells every key that is pressed, from a thread of its own; a context manager.

    The terminal gives keys at once and does not show them while it lasts, and is what it was afterwards.
    """

    def __init__(self, terminal: int, tell: Callable[[str], None]) -> None:
        self._terminal = terminal
        self._tell = tell
        self._before: list[Any] = []
        self._end, self._stop = -1, -1
        self._thread = threading.Thread(target=self._read, name="keys", daemon=True)

    def __enter__(self) -> Keys:
        import termios

        self._before = termios.tcgetattr(self._terminal)
        self._end, self._stop = os.pipe()
        atexit.register(self._give_back)  # should a second Ctrl-C come before the first is dealt with
        self.take()
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        try:
            self._give_back()
            atexit.unregister(self._give_back)
        finally:
            os.write(self._stop, b"\0")  # closing would not do: a child may hold a copy
            self._thread.join()
            os.close(self._stop)
            os.close(self._end)

    def take(self) -> None:
        """Have keys given at once; again after the process was stopped and goes on. Ctrl-C stays as it is."""
        import termios

        now = [*self._before]
        now[3] = now[3] & ~(termios.ICANON | termios.ECHO)
        now[6] = [*now[6]]
        now[6][termios.VMIN], now[6][termios.VTIME] = 1, 0
        termios.tcsetattr(self._terminal, termios.TCSANOW, now)

    def _give_back(self) -> None:
        import termios

        with suppress(termios.error):  # the terminal is gone
            termios.tcsetattr(self._terminal, termios.TCSANOW, self._before)

    def _read(self) -> None:
        while True:
            ready = select.select([self._terminal, self._end], [], [])[0]
            if self._end in ready:
                return
            try:
                read = os.read(self._terminal, 64)
            except OSError:
                read = b""
            for key in _keys(read):
                self._tell(key)
            if not read:
                return


def _keys(read: bytes) -> Sequence[str]:
    """The keys of what was read at once; those that send a sequence are none of ours."""
    if not read:
        return [GONE]
    return list(_SEQUENCE.sub("", read.decode("ascii", "ignore")).lower())
