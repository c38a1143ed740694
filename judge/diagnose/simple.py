"""Builders of simple cases for any problem: numbers of few digits, many of them alike.

A case's numbers come from a small pool, so that many of them are equal: what is special in a problem is
most often that two of its numbers are the same. The pool's numbers are small integers m, or m·10^k, or
m·10^k + n, and all may be multiplied by 10^-u. Each rung of the ladder fixes k and u; the first steps are
the simplest. On a lone rung one coordinate of one point is m·10^k and all other numbers are small: what only
just happens, far from all the rest, is found in no other way.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import Struct

from judge.data.draw import Draw
from judge.problem import Case, Problem
from judge.problem.model import Parameter
from judge.values import parameters
from judge.values.atoms import Number
from judge.values.types import is_pair

_POOL = 3


class Rung(Struct, frozen=True):
    """One kind of simple numbers: up to `reach`, with tens of 10^`tens`, in units of 10^-`unit`.

    With `lone`, a single coordinate has the tens.
    """

    reach: int
    tens: int = 0
    unit: int = 0
    floats: bool = False
    lone: bool = False

    def case(self, draw: Draw, problem: Problem) -> Case:
        """A case of such numbers; it need not keep the bounds or the promise."""
        return self._lone(draw, problem) if self.lone else self._pooled(draw, problem)

    def _pooled(self, draw: Draw, problem: Problem) -> Case:
        pool = [self._number(draw) for _ in range(_POOL)]

        def number(positive: bool) -> Number:
            place = draw.integer(0, 2 * _POOL)
            if place > _POOL:
                value = pool[place - _POOL - 1]
            else:
                value = draw.integer(0, 1) * draw.integer(0, self.reach)
            if not positive:
                value *= draw.sign()
            return self._typed(value)

        return tuple(
            parameters.simple(parameter.type, draw.integer, number, positive=parameter.low >= 0)
            for parameter in problem.parameters
        )

    def _lone(self, draw: Draw, problem: Problem) -> Case:
        points = [is_pair(parameter.type) for parameter in problem.parameters]
        far = draw.integer(0, 2 * sum(points) - 1)  # the coordinate that is far away
        coordinates = iter(range(2 * sum(points)))

        def coordinate() -> Number:
            size = 10**self.tens if next(coordinates) == far else 1
            return self._typed(draw.integer(size > 1, self.reach) * size * draw.sign())

        return tuple(
            (coordinate(), coordinate())
            if is_point
            else self._typed(draw.integer(0, self.reach) * (parameter.low >= 0))
            for is_point, parameter in zip(points, problem.parameters, strict=True)
        )

    def _number(self, draw: Draw) -> int:
        near = draw.integer(0, self.reach)
        if not self.tens:
            return near
        kind = draw.integer(0, 2)
        far: int = draw.integer(1, self.reach) * 10**self.tens
        return (near, far, far + near * draw.sign())[kind]

    def _typed(self, value: int) -> Number:
        if self.unit:
            return value / int(10**self.unit)
        return float(value) if self.floats else value


Step = list[tuple[Rung, int]]


def ladder(problem: Problem) -> Iterator[Step]:
    """The steps for a problem, the simplest first: rungs, and how many cases to try of each."""
    yield [(Rung(1), 100), (Rung(3), 400)]
    yield [(Rung(9), 400)]
    if not any(parameter.type.measured for parameter in problem.parameters):
        for tens in (1, 2, 3, 4, 5, 6, 8, 10, 16, 20, 30):
            yield [(Rung(3, tens), 250)]
        return
    yield [(Rung(3, floats=True), 150), (Rung(3, unit=1), 100)]
    for tens in (2, 4, 6, 8):
        yield [(Rung(3, tens), 150), (Rung(3, tens, floats=True), 150)]
        if tens < 6 and _has_lone(problem.parameters):
            yield [(Rung(2, lone, lone=True), 150) for lone in (tens, tens + 1)]
    for unit in (9, 7, 11, 13, 5, 3):
        yield [(Rung(3, unit=unit), 150)]
    for unit in (3, 6):
        yield [(Rung(3, tens=unit, unit=unit), 150)]


def _has_lone(parameters: Sequence[Parameter]) -> bool:
    """Whether a single coordinate may be far away: there are points, and beside them only numbers."""
    points = [is_pair(parameter.type) for parameter in parameters]
    return any(points) and all(
        is_point or parameter.type.width == 1 for is_point, parameter in zip(points, parameters, strict=True)
    )
