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
from operator import sub

from judge.compare import AnyTarget, CountTarget, ParameterTarget
from judge.compare.outline import Outline

_CLOSE = 1e-3  # of the largest number: an error that is smaller is one of digits
_SAME = 0.05  # of the larger error: numbers that differ by less are the same
_SAME_POWERS = 1.5  # powers of ten between two errors of digits that pass for the same


class Alike(IntEnum):
    """What two wrong answers have in common."""

    NOTHING = 0
    KIND = 1
    ALL = 2


class WrongAnswer:
    """A wrong answer to one case, to hold others against."""

    def __init__(self, given: Outline, target: AnyTarget) -> None:
        self._given = given
        self._target = target
        self._wanted = wanted_numbers(target)
        self._kind = _kind_of(given, target, self._wanted)
        self._known: dict[Outline, Alike] = {given: Alike.ALL}

    def alike(self, other: Outline) -> Alike:
        """How alike they are; symmetric."""
        found = self._known.get(other)
        if found is None:
            found = self._known[other] = self._compared(other)
        return found

    def _compared(self, other: Outline) -> Alike:
        kind = _kind_of(other, self._target, self._wanted)
        if _ENDED in (kind, self._kind):
            return Alike.KIND  # nobody knows what would have come after the exception
        if kind != self._kind:
            return Alike.NOTHING
        if kind == "sentinel":
            return Alike.ALL
        numbers, others = self._given[1], other[1]
        if not numbers or len(numbers) != len(others) or not all(map(math.isfinite, (*numbers, *others))):
            return Alike.KIND
        if _same_numbers(numbers, others, self._wanted):
            return Alike.ALL
        if kind == "digits" and _same_powers(numbers, others, self._wanted):
            return Alike.KIND
        return Alike.NOTHING


def _kind_of(given: Outline, target: AnyTarget, wanted: Sequence[float]) -> str:
    form, numbers = given
    if form.startswith(("raised ", "stopped ")):
        return _ENDED
    if isinstance(target, CountTarget):
        return _count_kind(form, numbers)
    if isinstance(target, ParameterTarget):
        return _parameter_kind(form, numbers, wanted)
    return _points_kind(form, numbers, wanted)


_ENDED = "ended"
_COUNTS = (0.0, 1.0, 2.0)


def _count_kind(form: str, numbers: Sequence[float]) -> str:
    if form in ("count", "type float") and (not numbers or numbers[0] not in _COUNTS):
        return "sentinel"
    return f"{numbers[0]:.0f}" if form == "count" else form


def _parameter_kind(form: str, numbers: Sequence[float], wanted: Sequence[float]) -> str:
    if form == "type float":  # inf or nan
        return "sentinel"
    if form != "number":
        return form
    (t,) = numbers
    if not wanted:
        return "invented" if 0.0 <= t < math.inf else "sentinel"
    if not math.isfinite(t):
        return "sentinel"
    if abs(t - wanted[0]) <= _CLOSE * max(abs(t), abs(wanted[0])):
        return "digits"
    if t < 0.0:
        return "negative"
    return "less" if t < wanted[0] else "more"


def _points_kind(form: str, numbers: Sequence[float], wanted: Sequence[float]) -> str:
    name, _, count = form.partition(" ")
    if name != "points":
        return form
    if 2 * int(count) != len(wanted):
        return f"{'fewer' if 2 * int(count) < len(wanted) else 'more'} {count}"
    size = max(map(abs, (*numbers, *wanted)))
    if _largest(numbers, wanted) <= _CLOSE * size:
        return "digits"
    turned = (*wanted[2:], *wanted[:2])
    if len(wanted) == 4 and _largest(numbers, turned) <= _SAME * _largest(wanted, turned):
        return "reordered"
    return "elsewhere"


def _same_numbers(numbers: Sequence[float], others: Sequence[float], wanted: Sequence[float]) -> bool:
    """Whether two answers of a kind are the same, as far as one can expect of different programs."""
    between = _largest(numbers, others)
    if len(wanted) != len(numbers):  # as two points where one is wanted
        return between <= _CLOSE * max(map(abs, (*numbers, *others, *wanted)))
    return between <= _SAME * max(_largest(numbers, wanted), _largest(others, wanted))


def _same_powers(numbers: Sequence[float], others: Sequence[float], wanted: Sequence[float]) -> bool:
    """Whether two small errors are of about the same size."""
    errors = _largest(numbers, wanted), _largest(others, wanted)
    return min(errors) > 0.0 and abs(math.log10(errors[0] / errors[1])) <= _SAME_POWERS


def wanted_numbers(target: AnyTarget) -> tuple[float, ...]:
    """The numbers of the right answer, correctly rounded."""
    if isinstance(target, CountTarget):
        return () if target.value is None else (float(target.value),)
    if isinstance(target, ParameterTarget):
        return () if target.t is None else (target.t[2],)
    return tuple(number[2] for point in target.points for number in point)


def _largest(numbers: Sequence[float], others: Sequence[float]) -> float:
    """The largest difference of two numbers in the same place."""
    return max(map(abs, map(sub, numbers, others)), default=0.0)
