"""Two circles: how they lie, where they meet, and where their common tangents touch the first.

With v = C2 − C1, d = |v| and n = (−vy, vx), which is v turned to the left, the common points are
C1 + (m·v ± √(4d²r1² − m²)·n)/(2d²) for m = d² + r1² − r2². A common tangent has a unit normal N with
N·v = r1 − r2 (an outer one) or r1 + r2 (an inner one), and touches at C1 + r1·N.
"""

from __future__ import annotations

from enum import Enum
from fractions import Fraction

from judge.exact.surd import Surd, integers
from judge.geometry.quadratic import Number, Vector
from judge.geometry.sure import DecisionWords, Sure
from judge.values.answers import Real

SHARE = 1000  # of e, that lengths which answers are divided by have at least

_AWAY = "They must touch exactly, or stay at least 1e-7·e away from touching."
OUTER = DecisionWords(
    "The circles almost touch from outside",
    _AWAY,
    ("the circles overlap", "the circles touch exactly from outside", "the circles are apart"),
)
INNER = DecisionWords(
    "The circles almost touch, one inside the other",
    _AWAY,
    (
        "one circle is inside the other and away from it",
        "the circles touch exactly, one inside the other",
        "one circle reaches out of the other",
    ),
)
SAME = DecisionWords(
    "The circles are almost the same",
    "Their radii must be equal, or at least 1e-7·e apart.",
    ("r1 is less than r2", "the circles are exactly the same", "r1 is more than r2"),
)


class Lie(Enum):
    """How two circles lie to one another."""

    SAME = "same"  # one and the same circle
    POINT = "point"  # one and the same point, both radii being 0
    APART = "apart"
    OUTER = "outer"  # they touch from outside
    CROSSING = "crossing"
    INNER = "inner"  # they touch, one inside the other
    INSIDE = "inside"  # one inside the other, perhaps about the same centre


class Pair:
    """The circles (C1, r1) and (C2, r2); e = max(r1, r2, |C2 − C1|∞).

    Raises ValueError for nan, infinities and a radius below 0. Points are in the caller's units.
    """

    def __init__(self, cx1: Number, cy1: Number, r1: Number, cx2: Number, cy2: Number, r2: Number) -> None:
        (self.x, self.y, self.r1, x2, y2, self.r2), self.shift = integers(cx1, cy1, r1, cx2, cy2, r2)
        if self.r1 < 0 or self.r2 < 0:
            raise ValueError("a radius is negative")
        self.dx, self.dy = x2 - self.x, y2 - self.y
        self.square = self.dx * self.dx + self.dy * self.dy
        self.sure = Sure(max(self.r1, self.r2, abs(self.dx), abs(self.dy)))
        self._lie: Lie | None = None

    def lie(self) -> Lie:
        """How they lie. InvalidCase for a touch that is not exact, and centres nearly one, within e/1000."""
        if self._lie is None:
            self.sure.least(self.square, SHARE, "The distance of the centres")
            self._lie = self._apart() if self.square else self._about_one_centre()
        return self._lie

    def points(self) -> list[Vector] | None:
        """The common points, the one on the left of C1→C2 first; None for one and the same circle.

        A touch is one point, and so is one and the same point.
        """
        lie = self.lie()
        if lie is Lie.SAME:
            return None
        if lie is Lie.CROSSING:
            square, whole = self.square, self.r1 * self.r1
            along = square + whole - self.r2 * self.r2
            over = 4 * square * whole - along * along
            return [self._from_first(along, side, over, 2 * square) for side in (1, -1)]
        if lie is Lie.POINT:
            return [self._from_first(0, 0, 0, 1)]
        if lie is Lie.OUTER:
            return [self._from_first(self.r1, 0, 0, self.r1 + self.r2)]
        return [self._from_first(self.r1, 0, 0, self.r1 - self.r2)] if lie is Lie.INNER else []

    def tangents(self) -> list[Vector]:
        """Where common tangents touch circle 1: the outer ones, then the inner ones.

        Of two the one on the left of C1→C2 comes first; where the circles touch, two are one. InvalidCase
        where r1, r2 or the distance of the centres is 0 or less than e/1000.
        """
        named = (
            (self.r1 * self.r1, "r1"),
            (self.r2 * self.r2, "r2"),
            (self.square, "The distance of the centres"),
        )
        for square, name in named:
            self.sure.least(square, SHARE, name, zero=False)
        self.lie()
        found = []
        for reach in (self.r1 - self.r2, self.r1 + self.r2):
            over = self.square - reach * reach
            if over >= 0:
                sides = (1, -1) if over else (0,)
                found += [
                    self._from_first(self.r1 * reach, side * self.r1, over, self.square) for side in sides
                ]
        return found

    def _apart(self) -> Lie:
        outer = self.sure.distance(self.square, self.r1 + self.r2, what=OUTER)
        inner = self.sure.distance(self.square, abs(self.r1 - self.r2), what=INNER)
        if outer >= 0:
            return Lie.APART if outer else Lie.OUTER
        return (Lie.INSIDE, Lie.INNER, Lie.CROSSING)[inner + 1]

    def _about_one_centre(self) -> Lie:
        if self.sure.sign(self.r1 - self.r2, what=SAME):
            return Lie.INSIDE
        return Lie.SAME if self.r1 else Lie.POINT

    def _from_first(self, along: int, across: int, over: int, bottom: int) -> Vector:
        """C1 + (along·v + across·√over·n)/bottom."""
        unit, scaled = Fraction(self.sure.size, 1 << self.shift), bottom << self.shift
        return (
            Real(Surd(self.x * bottom + along * self.dx, -across * self.dy, over, scaled), unit),
            Real(Surd(self.y * bottom + along * self.dy, across * self.dx, over, scaled), unit),
        )
