"""Interactor: talks with a program as FORMAT's talk of validate_problem.py does.

usage: validate.py INPUT ANSWER FEEDBACK_DIR    42 accepted, 43 wrong, 1 the package is inconsistent

Its input is what the program prints, and its output what the program reads. accepted.json beside this file
holds, by the SHA-256 of each input file, the arguments of its case, as Python writes them.

Needs Python 3.6 or newer, CPython or PyPy, and nothing else.
"""

import hashlib
import json
import os
import re
import sys
from ast import literal_eval
from importlib import import_module
from queue import Queue
from threading import Thread
from typing import Any

INTEGER = re.compile(r"[+-]?[0-9]{1,30}")
TABLE = "accepted.json"
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


def why_not(case: Any) -> Any:
    """Why a program is wrong; None for a right one."""
    sys.modules["judge.problem.declare"] = import_module("validate_declare")
    program = Program()
    try:
        why = import_module("validate_problem").FORMAT.talk(program, *case)
    except Wrong as wrong:
        return str(wrong)
    except Ended:
        return "the program ended before the dialogue did"
    more = program.rest().strip() if why is None else ""
    return "it prints %r after the dialogue" % more[:BRIEF] if more else why


def main() -> int:
    """The exit status."""
    with open(sys.argv[1], "rb") as file:
        key = hashlib.sha256(file.read()).hexdigest()
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), TABLE), encoding="utf-8") as file:
        files = json.load(file)["files"]
    if key not in files:
        sys.stderr.write("%s is not an input of this package: export the package again\n" % sys.argv[1])
        return 1
    why = why_not(literal_eval(files[key][0]))
    if why is not None:
        path = os.path.join(sys.argv[3], "judgemessage.txt")
        with open(path, "a", encoding="utf-8", errors="backslashreplace") as file:
            file.write("%s\n" % why)
    return 42 if why is None else 43


if __name__ == "__main__":
    sys.exit(main())
