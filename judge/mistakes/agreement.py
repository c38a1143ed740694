"""How alike two wrong answers to one case are: the same, of one kind, or different.

What kind of wrong answer it is depends on the right one:

    none, ended, type …, text     no answer of the form that was asked for
    sentinel                      a number that no case has for an answer, such as -1, 99 and inf
    0, 1, 2                       another count
    fewer m, more m               m points, where fewer or more are wanted
    reordered, digits, elsewhere  the wanted points the wrong way round; a little off; somewhere else
    invented                      a parameter where there is none
    negative, digits, less, more  another parameter than the wanted one

Numbers are held against each other by how they miss the wanted ones, whatever the size of the figure: a
mistake that loses digits errs by about the same amount in every program, but hardly ever by the same digits.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from enum import IntEnum

from judge.values import outline
from judge.values.atoms import Type
from judge.values.outline import CLOSE, SAME, Outline, Usual, largest

_ENDED = "ended"
_SAME_POWERS = 1.5  # powers of ten between two errors of digits that pass for the same


class Alike(IntEnum):
    """What two wrong answers have in common."""

    NOTHING = 0
    KIND = 1
    ALL = 2


class WrongAnswer:
    """A wrong answer to one case, to hold others against; `right` is the outline of the right one."""

    def __init__(self, given: Outline, right: Outline, answer: Type, usual: Usual) -> None:
        self._given = given
        self._right = right
        self._answer = answer
        self._usual = usual
        self._kind = self._kind_of(given)
        self._known: dict[Outline, Alike] = {given: Alike.ALL}

    def alike(self, other: Outline, kind: str | None = None) -> Alike:
        """How alike they are; symmetric. `kind` is that of the other one, where it is known."""
        found = self._known.get(other)
        if found is None:
            found = self._known[other] = self._compared(other, kind or self._kind_of(other))
        return found

    def _compared(self, other: Outline, kind: str) -> Alike:
        if _ENDED in (kind, self._kind):
            return Alike.KIND  # nobody knows what would have come after the exception
        if kind != self._kind:
            return Alike.NOTHING
        if kind == "sentinel":
            return Alike.ALL
        numbers, others = self._given[1], other[1]
        if not numbers or len(numbers) != len(others) or not all(map(math.isfinite, (*numbers, *others))):
            return Alike.KIND
        if _same_numbers(numbers, others, self._right[1]):
            return Alike.ALL
        if kind == "digits" and _same_powers(numbers, others, self._right[1]):
            return Alike.KIND
        return Alike.NOTHING

    def _kind_of(self, given: Outline) -> str:
        return kind_of(given, self._right, self._answer, self._usual)


def is_ended(given: Outline) -> bool:
    """Whether there is an exception, or an early end, in place of an answer."""
    return given[0].startswith(("raised ", "stopped "))


def kind_of(given: Outline, right: Outline, answer: Type, usual: Usual) -> str:
    """What kind of wrong answer one is."""
    if is_ended(given):
        return _ENDED
    return outline.kind(answer, given, right, usual)


def _same_numbers(numbers: Sequence[float], others: Sequence[float], wanted: Sequence[float]) -> bool:
    """Whether two answers of a kind are the same, as far as one can expect of different programs."""
    between = largest(numbers, others)
    if len(wanted) != len(numbers):  # as two points where one is wanted
        return between <= CLOSE * max(map(abs, (*numbers, *others, *wanted)))
    return between <= SAME * max(largest(numbers, wanted), largest(others, wanted))


def _same_powers(numbers: Sequence[float], others: Sequence[float], wanted: Sequence[float]) -> bool:
    """Whether two small errors are of about the same size."""
    errors = largest(numbers, wanted), largest(others, wanted)
    return min(errors) > 0.0 and abs(math.log10(errors[0] / errors[1])) <= _SAME_POWERS
