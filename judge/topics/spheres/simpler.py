"""Simpler spheres and rays like a given one: about the origin, in fewer axes, in numbers of few digits.

Nothing here need be right: a candidate counts only if it is valid and the submission fails on it.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import permutations
from typing import Any

from judge.exact import Surd
from judge.problem import Case, Problem
from judge.topics.spheres.hit import Number, Triple

_DIGITS = (1, 2, 3, 6)


def simpler(_problem: Problem, case: Case) -> Iterator[Case]:
    """Cases that are simpler as a whole."""
    centre, radius, origin, direction = case
    if any(centre):
        near = _less(origin, centre)
        yield (0, 0, 0), radius, near, direction
        yield (0, 0, 0), radius, near, tuple(map(_sign, direction))
    yield centre, radius, origin, tuple(map(_sign, direction))
    for axis in range(3):
        flat = [list(each) for each in (centre, origin, direction)]
        for each in flat:
            each[axis] = 0
        yield tuple(flat[0]), radius, tuple(flat[1]), tuple(flat[2])
    for order in permutations(range(3)):
        if order != (0, 1, 2):
            yield _picked(centre, order), radius, _picked(origin, order), _picked(direction, order)
    for digits in _DIGITS:
        yield (
            _short(centre, digits),
            _few(radius, digits),
            _short(origin, digits),
            _short(direction, digits),
        )


def special(case: Case) -> int:
    """Whether the origin is the centre, and one more for a radius of 0 or no direction."""
    centre, radius, origin, direction = case
    return sum((centre == origin, radius == 0, not any(direction)))


def _picked(point: Any, order: tuple[int, ...]) -> tuple[Number, ...]:
    return tuple(point[axis] for axis in order)


def _sign(value: Number) -> int:
    return (value > 0) - (value < 0)


def _less(point: Triple, by: Triple) -> tuple[Number, ...]:
    return tuple(_difference(x, y) for x, y in zip(point, by, strict=True))


def _difference(x: Number, y: Number) -> Number:
    if isinstance(x, int) and isinstance(y, int):
        return x - y
    return float(Fraction(x) - Fraction(y))


def _short(point: Any, digits: int) -> tuple[Number, ...]:
    return tuple(_few(value, digits) for value in point)


def _few(value: Number, digits: int) -> Number:
    short = float(Surd.of(value).decimal(digits))
    return int(short) if isinstance(value, int) else short
