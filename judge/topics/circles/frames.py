"""A circle that moves from frame to frame, and a line that stands: whether they meet, shown without flicker.

A case is (circles, O, D, h), a circle a frame; judge.geometry.frames answers it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import hypot
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.exact.dyadic import integers
from judge.exact.surd import Surd
from judge.problem import Case, Problem
from judge.problem.model import Number, Point
from judge.problem.topic import Shown, Topic

if TYPE_CHECKING:
    from judge.drawing import Picture

_DIGITS = (1, 2, 3, 5)


class Frame(Struct, frozen=True):
    """One circle beside the line, in integers: `reach` is (D × f)²·a, so d is √reach/a.

    `x` and `y` are |O − C|, and the extent is the largest of them and r.
    """

    radius: int
    x: int
    y: int
    reach: int
    a: int
    shift: int  # a length of 1 is 2**shift

    @property
    def extent(self) -> int:
        """The frame's own size e."""
        return max(self.radius, self.x, self.y)

    def gap(self, share: Fraction) -> Surd:
        """d less that share of r, in extents."""
        n, m = share.numerator, share.denominator
        return Surd(-self.radius * n * self.a, 1, self.reach * m * m, self.extent * m * self.a)


def frames_of(circles: Sequence[tuple[Number, Number, Number]], origin: Point, way: Point) -> list[Frame]:
    """Each circle and the line O + t·D. Raises ValueError for nan, infinities and a radius below 0."""
    numbers, shift = integers(*origin, *way, *(value for circle in circles for value in circle))
    ox, oy, dx, dy = numbers[:4]
    a, found = dx * dx + dy * dy, []
    for x, y, radius in zip(*(numbers[at::3] for at in (4, 5, 6)), strict=True):
        if radius < 0:
            raise ValueError("a radius is negative")
        fx, fy = ox - x, oy - y
        k = dx * fy - dy * fx
        found.append(Frame(radius, abs(fx), abs(fy), k * k * a, a, shift))
    return found


# -- the topic ---------------------------------------------------------------------------------------------


def _simpler(_problem: Problem, case: Case) -> Iterator[Case]:
    """The line level through the origin, each circle straight above it; at its own size and about 1."""
    circles, origin, way, h = case
    size = hypot(*way)
    if not size:
        return
    laid = []
    for x, y, radius in circles:
        away = abs(way[0] * (origin[1] - y) - way[1] * (origin[0] - x)) / size
        laid.append((away, radius))
    unit = laid[0][1] or 1
    for scale in (unit, 1):
        for digits in _DIGITS:
            above = tuple(
                (0, _few(away / scale, digits), _few(radius / scale, digits)) for away, radius in laid
            )
            yield above, (0, 0), (1, 0), _few(h, min(digits, 2))
            yield above, (0, 0), (1, 0), h
    yield tuple((0, away, radius) for away, radius in laid), (0, 0), (1, 0), h


def _few(value: Number, digits: int) -> Number:
    short = float(f"{value:.{digits}g}")
    return int(short) if short.is_integer() else short


def _picture(shown: Shown) -> Picture | None:
    from judge.topics.circles.picture.strip import strip  # late: most problems are loaded to be judged

    return strip(shown)


FRAMES = Topic(simpler=_simpler, picture=_picture)
