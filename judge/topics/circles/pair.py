"""Two circles in scaled integers: how they lie to one another, and where they meet.

With v = C2 − C1 and |v|² = v·v, the common points are on the radical line m = 2·v·X, m = |v|² + r1² − r2², X
seen from C1: C1 + (m·v ± √(4|v|²r1² − m²)·n)/(2|v|²) with n = (−vy, vx), v turned to the left.
"""

from __future__ import annotations

from enum import Enum
from fractions import Fraction

from msgspec import Struct
from msgspec.structs import replace

from judge.exact.dyadic import integers
from judge.exact.surd import Surd, make
from judge.topics.circles.bands import Bands
from judge.topics.circles.line import CircleLine, Number

_CENTRES = "the centres are neither together nor far enough apart"


class Lie(Enum):
    """How two circles lie to one another."""

    SAME = "same"  # one and the same circle
    POINT = "point"  # one and the same point, both radii being 0
    APART = "apart"
    OUTER = "outer"  # they touch from outside
    CROSSING = "crossing"
    INNER = "inner"  # they touch, one inside the other
    INSIDE = "inside"  # one inside the other, perhaps about the same centre


class CirclePair(Struct, frozen=True):
    """The circles (C1, r1) and (C2, r2), every length an integer that counts units of 2**-shift.

    (dx, dy) is v = C2 − C1, and `square` is v·v. `extent` is the case's own size e = max(r1, r2, |v|∞).
    """

    x1: int
    y1: int
    r1: int
    dx: int
    dy: int
    r2: int
    shift: int
    extent: int
    square: int

    @classmethod
    def of(cls, cx1: Number, cy1: Number, r1: Number, cx2: Number, cy2: Number, r2: Number) -> CirclePair:
        """The pair of these circles. Raises ValueError for nan, infinities and a radius below 0."""
        (x1, y1, s1, x2, y2, s2), shift = integers(cx1, cy1, r1, cx2, cy2, r2)
        if s1 < 0 or s2 < 0:
            raise ValueError("a radius is negative")
        dx, dy = x2 - x1, y2 - y1
        return cls(x1, y1, s1, dx, dy, s2, shift, max(s1, s2, abs(dx), abs(dy)), dx * dx + dy * dy)

    def lie(self, bands: Bands) -> Lie:
        """How the circles lie, `bands.snap` of the extent deciding what touches and what is the same."""
        if bands.beside(self.square, 0, self.extent) == 0:
            if bands.beside((self.r1 - self.r2) ** 2, 0, self.extent) != 0:
                return Lie.INSIDE
            return Lie.SAME if self.extent else Lie.POINT
        outer, inner = (bands.beside(self.square, reach, self.extent) for reach in self.reaches)
        if outer >= 0:
            return Lie.APART if outer else Lie.OUTER
        return (Lie.INSIDE, Lie.INNER, Lie.CROSSING)[inner + 1]

    @property
    def reaches(self) -> tuple[int, int]:
        """How far apart the centres are where the circles touch: from outside, and one inside the other."""
        return self.r1 + self.r2, abs(self.r1 - self.r2)

    def points(self, lie: Lie) -> list[tuple[Surd, Surd]]:
        """The common points of circles that lie so, in the caller's units, the one left of C1→C2 first.

        A touch is one point; the same circle has none that could be told.
        """
        if lie is Lie.CROSSING:
            return [self._crossing(1), self._crossing(-1)]
        if lie in (Lie.POINT, Lie.OUTER, Lie.INNER):
            return [self.on_first(-1 if lie is Lie.INNER and self.r1 <= self.r2 else 1)]
        return []

    def tangents(self, bands: Bands) -> list[tuple[Surd, Surd]]:
        """Where common tangents touch circle 1, in the caller's units: outer ones, then inner ones.

        Their unit normals n have n·v = r1 − r2, or r1 + r2: n = (q·v ± √(|v|² − q²)·v⊥)/|v|². Of two the one
        on the left of C1→C2 comes first; where the circles touch, two are one.
        """
        found = []
        for reach in (self.r1 - self.r2, self.r1 + self.r2):
            side = bands.beside(self.square, abs(reach), self.extent)
            if side == 0:
                found.append(self.on_first(1 if reach >= 0 else -1))
            elif side > 0:
                found += [self._tangent(reach, 1), self._tangent(reach, -1)]
        return found

    def small(self, least: Fraction) -> str | None:
        """Which of the radii and the centres' distance is less than that part of the extent, if any."""
        bound = (least.numerator * self.extent) ** 2
        squares = (self.r1 * self.r1, self.r2 * self.r2, self.square)
        for square, name in zip(squares, ("r1", "r2", "the centres' distance"), strict=True):
            if square * least.denominator**2 < bound or not square:
                return f"{name} is too small a part of the extent"
        return None

    def _tangent(self, reach: int, side: int) -> tuple[Surd, Surd]:
        square, along, across = self.square, self.r1 * reach, side * self.r1
        over, bottom = square - reach * reach, square << self.shift
        return (
            Surd(self.x1 * square + along * self.dx, -across * self.dy, over, bottom),
            Surd(self.y1 * square + along * self.dy, across * self.dx, over, bottom),
        )

    def _crossing(self, side: int) -> tuple[Surd, Surd]:
        square = self.square
        along = square + self.r1 * self.r1 - self.r2 * self.r2
        over, bottom = 4 * square * self.r1 * self.r1 - along * along, 2 * square << self.shift
        return (
            Surd(2 * self.x1 * square + along * self.dx, -side * self.dy, over, bottom),
            Surd(2 * self.y1 * square + along * self.dy, side * self.dx, over, bottom),
        )

    def on_first(self, side: int) -> tuple[Surd, Surd]:
        """The point of circle 1 towards C2 (side 1) or away from it (−1); C1 itself for one centre."""
        if not self.square:
            unit = 1 << self.shift
            return make(self.x1, 0, 0, unit), make(self.y1, 0, 0, unit)
        bottom, reach = self.square << self.shift, side * self.r1
        return (
            Surd(self.x1 * self.square, reach * self.dx, self.square, bottom),
            Surd(self.y1 * self.square, reach * self.dy, self.square, bottom),
        )

    def extent_length(self) -> Surd:
        """The extent e in the caller's units."""
        return make(self.extent, 0, 0, 1 << self.shift)

    def circles(self) -> tuple[CircleLine, CircleLine]:
        """Both circles in the pair's units, each with the other's centre for its line's points."""
        first, second = (self.x1, self.y1), (self.x1 + self.dx, self.y1 + self.dy)
        return tuple(  # type: ignore[return-value]  # two
            replace(CircleLine.through(*at, radius, other, other), shift=self.shift, extent=self.extent)
            for at, radius, other in ((first, self.r1, second), (second, self.r2, first))
        )
