"""Problems with the arguments (cx, cy, r, ax, ay, bx, by): a circle and a line, number by number.

SEVEN             their topic: that of a line, its points put together first
discriminant(…)   Δ = r²·a − k² of such a case, exactly, with the terms that it is made of
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from judge.exact.dyadic import integers
from judge.problem import Case, Problem
from judge.problem.model import Number
from judge.problem.topic import Shown, Topic
from judge.topics.circles import LINE
from judge.values import Enclosure

if TYPE_CHECKING:
    from judge.drawing import Picture


class Discriminant(Struct, frozen=True):
    """Integers that count units: `reach` is r²·a, `k` the cross product, `whole` M = |dx·fy| + |dy·fx|.

    One unit of r²·a, k² and M² is `unit`.
    """

    reach: int
    k: int
    whole: int
    unit: Fraction

    @property
    def delta(self) -> int:
        """r²·a − k²."""
        return self.reach - self.k * self.k


def discriminant(*case: Number) -> Discriminant:
    """The terms of Δ for the seven numbers, with D = B − A and f = A − C; 0 for A == B."""
    (icx, icy, ir, iax, iay, ibx, iby), shift = integers(*case)
    dx, dy, fx, fy = ibx - iax, iby - iay, iax - icx, iay - icy
    right, left = dx * fy, dy * fx
    return Discriminant(
        ir * ir * (dx * dx + dy * dy), right - left, abs(right) + abs(left), Fraction(1, 1 << 4 * shift)
    )


def _paired(case: Case) -> Case:
    cx, cy, r, ax, ay, bx, by = case
    return cx, cy, r, (ax, ay), (bx, by)


def _simpler(problem: Problem, case: Case) -> Iterator[Case]:
    if LINE.simpler is not None:
        for cx, cy, r, a, b in LINE.simpler(problem, _paired(case)):
            yield cx, cy, r, *a, *b


def _special(case: Case) -> int:
    return LINE.special(_paired(case)) if LINE.special is not None else 0


def _picture(shown: Shown) -> Picture | None:
    """The figure with its common points; what was given is a number, and no place in it."""
    if LINE.picture is None or len(shown.values) != 7:
        return None
    cx, cy, r, a, b = _paired(tuple(shown.values.values()))
    values = {"cx": cx, "cy": cy, "r": r, "A": a, "B": b}
    exact = shown.exact.x if isinstance(shown.exact, Enclosure) else shown.exact
    sign = (exact > 0) - (exact < 0)
    return LINE.picture(replace(shown, values=values, exact=None if a == b else 1 + sign, given=None))


SEVEN = Topic(simpler=_simpler, special=_special, picture=_picture)
