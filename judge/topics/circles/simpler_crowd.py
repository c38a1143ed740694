"""Simpler circles along a ray like given ones: O at the origin, D = (1, 0), numbers of few digits.

For cases that begin with (circles, O, D); another point, such as a light, is laid out with them, and a
program stays. Nothing here need be right: a candidate counts only if it is valid and the submission fails on
it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from decimal import Context, Decimal, localcontext
from fractions import Fraction
from typing import Any

from judge.problem import Case, Problem

_DIGITS = 60
_FINEST = 16  # digits that are kept at most
_Pair = tuple[Decimal, Decimal]


def simpler_crowds(problem: Problem, case: Case) -> Iterator[Case]:
    """Cases that are simpler as a whole."""
    circles, origin, direction, *rest = case
    if not any(direction):
        return
    floats = any(isinstance(each, float) for each in _numbers(case))
    with localcontext(Context(prec=_DIGITS)):
        laid = [(*_laid((x, y), origin, direction), _decimal(r)) for x, y, r in circles]
        # A program is left as it is: it is no pair of numbers in the plane.
        lights = [_laid(each, origin, direction) for each in rest if problem.parameters[3].name == "L"]
        for kept in range(1, _FINEST + 1):
            few = tuple(_rounded(circle, kept, floats) for circle in laid)
            others = [_rounded(each, kept, floats) for each in lights] or rest
            for along in ((1, 0), _level(direction, kept, floats)):
                yield few, (0, 0), along, *others


def special_crowd(case: Case) -> int:
    """How many circles have no radius, or are there twice."""
    circles = case[0]
    return sum(not r for _, _, r in circles) + len(circles) - len(set(circles))


def _numbers(value: Any) -> Iterator[Any]:
    if isinstance(value, tuple):
        for each in value:
            yield from _numbers(each)
    else:
        yield value


def _laid(point: Any, origin: Any, direction: Any) -> _Pair:
    """A place as seen from O, along D and to its left."""
    x, y = (Fraction(a) - Fraction(b) for a, b in zip(point, origin, strict=True))
    dx, dy = map(Fraction, direction)
    length = _decimal(dx * dx + dy * dy).sqrt()
    return _decimal(dx * x + dy * y) / length, _decimal(dx * y - dy * x) / length


def _level(direction: Any, kept: int, floats: bool) -> tuple[int | float, int]:
    dx, dy = map(Fraction, direction)
    return _number(_few(_decimal(dx * dx + dy * dy).sqrt(), kept), floats), 0


def _rounded(values: Iterable[Decimal], kept: int, floats: bool) -> tuple[int | float, ...]:
    return tuple(_number(_few(each, kept), floats) for each in values)


def _few(value: Decimal, digits: int) -> Decimal:
    return value.quantize(Decimal((0, (1,), value.adjusted() + 1 - digits))) if value else value


def _number(value: Decimal, floats: bool) -> int | float:
    if value == 0 or (value == value.to_integral_value() and not floats):
        return int(value)
    return float(value)


def _decimal(value: Any) -> Decimal:
    exact = Fraction(value)
    return Decimal(exact.numerator) / Decimal(exact.denominator)
