"""The tokens of a line of output, read strictly."""

from __future__ import annotations

import re

from judge.values.decode import Fault, Written, decimal, shown
from judge.values.outcome import Unreadable

_INTEGER = re.compile(r"[+-]?[0-9]{1,400}", re.ASCII)
_FOREIGN = re.compile(r"[^\t -~]")


def tokens_of(line: str) -> list[str]:
    """The tokens between blanks; raises Unreadable for what is not plain ASCII text."""
    line = line.removesuffix("\r")
    foreign = _FOREIGN.search(line)
    if foreign:
        name = "a NUL" if foreign[0] == "\0" else f"the character {foreign[0]!a}"
        raise Unreadable(f"{name} in the output: answers are plain ASCII text")
    return line.split()


class Tokens:
    """A line's tokens, taken one after the other.

    `meant` says what the whole line holds, `whole` that this is a single token; `root` is the type of it.
    """

    __slots__ = ("_at", "_words", "meant", "root", "whole")

    def __init__(self, words: list[str], meant: str, root: object, *, whole: bool) -> None:
        self._words = words
        self._at = 0
        self.meant = meant
        self.root = root
        self.whole = whole

    @property
    def left(self) -> int:
        """How many tokens are left."""
        return len(self._words) - self._at

    @property
    def ahead(self) -> str:
        """The next token, which stays; empty at the end."""
        return self._words[self._at] if self.left else ""

    def next(self) -> str:
        """Take a token; raises Unreadable at the end of the line."""
        if not self.left:
            raise Unreadable(f"the line ends too early: it holds {self.meant}")
        self._at += 1
        return self._words[self._at - 1]

    def integer(self, meant: str) -> int:
        """Take an integer."""
        token = self.next()
        if not _INTEGER.fullmatch(token):
            raise Unreadable(f"{shown(token)} where {meant} is meant: write a plain integer")
        return int(token)

    def number(self, meant: str) -> Written:
        """Take a decimal."""
        read = decimal(self.next())
        if isinstance(read, Fault):
            raise Unreadable(f"{read.text} where {meant} is meant: {read.remedy}")
        return read
