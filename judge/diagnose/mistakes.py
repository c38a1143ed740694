"""The mistakes that people make on a problem: each known by the wrong programs that make it.

    solutions/<id>/wrong/<mistake>.py, <mistake>-<variant>.py

A program's docstring begins with the mistake's name; what follows says what is wrong and what to do instead.
"""

from __future__ import annotations

import ast
import re
from pathlib import Path

from msgspec import Struct

from judge.language import programs
from judge.problem import Problem

_SENTENCE_END = re.compile(r"(?<=[.!?])\s+(?=[A-Z`\d])")


class Mistake(Struct, frozen=True):
    """One way of making a mistake: its name, what is wrong and what to do instead, and the program."""

    name: str
    advice: str
    path: Path
    source: bytes

    @property
    def sentence(self) -> str:
        """The first sentence of the advice: what is wrong."""
        return _SENTENCE_END.split(self.advice, maxsplit=1)[0]

    @property
    def usual(self) -> bool:
        """Whether it is the program called after the mistake, not one of its variants."""
        return self.path.stem == self.name


def known_mistakes(problem: Problem) -> list[Mistake]:
    """Every known-wrong program of the problem, the usual one of each mistake before its variants.

    A file that cannot be read or has no docstring is left out: `judge verify` tells of it. A pack may come
    without solutions.
    """
    mistakes = [each for path in programs(problem.solutions / "wrong") if (each := _read(path))]
    return sorted(mistakes, key=lambda each: (each.name, not each.usual, each.path.name))


def _read(path: Path) -> Mistake | None:
    try:
        source = path.read_bytes()
        docstring = ast.get_docstring(ast.parse(source)) or ""
    except (OSError, SyntaxError, ValueError, RecursionError):
        return None
    name, _, advice = docstring.partition("\n")
    if not name.strip():
        return None
    return Mistake(name.strip().rstrip("."), " ".join(advice.split()), path, source)
