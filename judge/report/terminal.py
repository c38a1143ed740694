"""A terminal that is drawn on again and again and answers single keys, and that is given back as it was."""

from __future__ import annotations

import atexit
import os
import re
import select
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress

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


@contextmanager
def keys(terminal: int, tell: Callable[[str], None]) -> Iterator[Callable[[], None]]:
    """Tells every key that is pressed, from a thread of its own, while the block runs.

    The terminal gives keys at once and does not show them meanwhile, and is what it was afterwards. What is
    given has that done again, after the process was stopped and goes on. Ctrl-C stays as it is.
    """
    import termios

    before = termios.tcgetattr(terminal)
    end, stop = os.pipe()

    def take() -> None:
        now = [*before]
        now[3] = now[3] & ~(termios.ICANON | termios.ECHO)
        now[6] = [*now[6]]
        now[6][termios.VMIN], now[6][termios.VTIME] = 1, 0
        termios.tcsetattr(terminal, termios.TCSANOW, now)

    def give_back() -> None:
        with suppress(termios.error):  # the terminal is gone
            termios.tcsetattr(terminal, termios.TCSANOW, before)

    def read() -> None:
        while end not in select.select([terminal, end], [], [])[0]:
            found = b""
            with suppress(OSError):
                found = os.read(terminal, 64)
            for key in _keys(found):
                tell(key)
            if not found:
                return

    thread = threading.Thread(target=read, name="keys", daemon=True)
    atexit.register(give_back)  # should a second Ctrl-C come before the first is dealt with
    take()
    thread.start()
    try:
        yield take
    finally:
        try:
            give_back()
            atexit.unregister(give_back)
        finally:
            os.write(stop, b"\0")  # closing would not do: a child may hold a copy
            thread.join()
            os.close(stop)
            os.close(end)


def _keys(read: bytes) -> Sequence[str]:
    """The keys of what was read at once; those that send a sequence are none of ours."""
    if not read:
        return [GONE]
    return list(_SEQUENCE.sub("", read.decode("ascii", "ignore")).lower())
