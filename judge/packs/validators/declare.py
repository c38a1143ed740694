"""Stands for `judge.problem.declare` in a package: as much of it as deciding an answer needs.

validate.py beside it imports the problem's own problem.py, which imports this. Needs Python 3.6 or newer.
"""

from typing import Any, Callable, NamedTuple, Optional


class InvalidCase(Exception):  # noqa: N818
    """The case breaks the statement's promise; no case of a package does."""


class Real(NamedTuple):
    """An exact real number, and the size that a tolerance counts in."""

    x: Any
    unit: Any = 0


class AnyOf(NamedTuple):
    """Any of these answers is right."""

    answers: Any


class Judged(NamedTuple):
    """Whatever `why_not` accepts."""

    why_not: Callable[[Any, str], Optional[str]]
    sample: Any
    group: str = ""


class Format(NamedTuple):
    """What a program reads and writes."""

    write: Optional[Callable[..., str]] = None
    read: Optional[Callable[[str], Any]] = None
    show: Optional[Callable[[Any], str]] = None
    talk: Optional[Callable[..., Any]] = None


def nothing(*given: Any, **named: Any) -> None:
    """What a package does not use: cases are drawn and shown elsewhere."""


Declared = Hooks = Tolerance = group = nothing
