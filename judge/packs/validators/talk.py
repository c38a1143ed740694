"""A dialogue: talks with a program as FORMAT's talk of validate_problem.py does.

validate.py beside it asks it: the standard input is what the program prints, the standard output what the
program reads.

Needs Python 3.6 or newer, CPython or PyPy, and nothing else.
"""

import os
import re
from queue import Queue
from threading import Thread
from typing import Any

INTEGER = re.compile(r"[+-]?[0-9]{1,30}")
AT_END, BRIEF = 100, 20  # times that a talk may turn to a program that has ended; characters that are quoted


class Wrong(Exception):  # noqa: N818
    """Why the program is wrong."""


class Ended(BaseException):
    """The program is gone, and the talk goes on."""


class Program:
    """The program that `talk` talks with; what it prints is taken up at once, or both could wait."""

    def __init__(self) -> None:
        self._lines = Queue()  # type: Any
        self._left, self._ended = AT_END, False
        Thread(target=self._listen, daemon=True).start()

    def _listen(self) -> None:
        for line in open(0, "rb", closefd=False):  # noqa: SIM115 - its own: it may wait there at the end
            self._lines.put(line)
        self._lines.put(b"")

    def _at_end(self) -> None:
        self._left -= 1
        if self._left < 0:
            raise Ended

    def say(self, *words: Any) -> None:
        """Write a line to it: the words with a blank between them."""
        rest = (" ".join(map(str, words)) + "\n").encode("ascii")
        try:
            while rest:
                rest = rest[os.write(1, rest) :]
        except BrokenPipeError:
            self._at_end()

    def hear(self) -> str:
        """Its next line, without the line feed; "" where it has ended."""
        line = b"" if self._ended else self._lines.get()
        if not line:
            self._ended = True
            self._at_end()
        return str(line.decode("ascii", "backslashreplace").rstrip("\r\n"))

    def hear_int(self, low: int, high: int) -> int:
        """The number in its next line. Where that holds none from low to high, the program is wrong."""
        text = self.hear().strip()
        if INTEGER.fullmatch(text) and low <= int(text) <= high:
            return int(text)
        why = "a number from %d to %d is expected" % (low, high)
        raise Wrong("the program ended, where " + why if self._ended else "%s, not %r" % (why, text[:BRIEF]))

    def rest(self) -> str:
        """What it prints until its end, once nobody talks with it."""
        os.close(1)
        return b"".join(iter(self._lines.get, b"") if not self._ended else ()).decode(
            "ascii", "backslashreplace"
        )


def why_not(talk: Any, case: Any) -> Any:
    """Why a program is wrong; None for a right one."""
    program = Program()
    try:
        why = talk(program, *case)
    except Wrong as wrong:
        return str(wrong)
    except Ended:
        return "the program ended before the dialogue did"
    more = program.rest().strip() if why is None else ""
    return "it prints %r after the dialogue" % more[:BRIEF] if more else why
