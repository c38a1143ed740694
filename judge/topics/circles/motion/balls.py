"""Two discs that move evenly, in scaled integers: seen from Q, the point P runs along a line.

Their distance is r + s where that line meets the circle of this radius about Q0: a ray and a circle.
"""

from __future__ import annotations

from msgspec import Struct
from msgspec.structs import replace

from judge.exact.dyadic import integers
from judge.exact.surd import Surd
from judge.topics.circles.bands import Bands
from judge.topics.circles.line import CircleLine, Number, Pair
from judge.topics.circles.motion.moments import Pace
from judge.topics.circles.plane import IntPoint


class Balls(Struct, frozen=True):
    """The discs (P, r) and (Q, s) from their places at t = 0 to those at t = 1, in units of 2**-shift.

    `line` is P as seen from Q at rest in Q0, with the circle of radius r + s about Q0; its extent is that of
    the case, e = max(r + s, |P1 − P0|∞, |Q0 − P0|∞, |Q1 − P0|∞).
    """

    p: tuple[IntPoint, IntPoint]
    q: tuple[IntPoint, IntPoint]
    r: int
    s: int
    line: CircleLine

    @classmethod
    def of(cls, p0: Pair, p1: Pair, r: Number, q0: Pair, q1: Pair, s: Number) -> Balls:
        """The discs of a case. Raises ValueError for nan, infinities and a radius below 0."""
        flat, shift = integers(*p0, *p1, *q0, *q1, r, s)
        ax, ay, bx, by, cx, cy, gx, gy, one, other = flat
        if one < 0 or other < 0:
            raise ValueError("a radius is negative")
        motion = (bx - ax) - (gx - cx), (by - ay) - (gy - cy)
        reach = one + other
        spans = (bx - ax, by - ay, cx - ax, cy - ay, gx - ax, gy - ay)
        seen = CircleLine.ray(cx, cy, reach, (ax, ay), motion)
        line = replace(seen, shift=shift, extent=max(reach, *map(abs, spans)))
        return cls(((ax, ay), (bx, by)), ((cx, cy), (gx, gy)), one, other, line)

    @property
    def pace(self) -> Pace:
        """How the moments of this case are told apart."""
        return Pace(self.line.extent, max(abs(self.line.dx), abs(self.line.dy)))

    @property
    def apart(self) -> int:
        """The centres' distance at the start, squared."""
        return (self.line.ax - self.line.cx) ** 2 + (self.line.ay - self.line.cy) ** 2

    def first(self, bands: Bands) -> Surd | None:
        """The first moment, anywhere on the line, at which the distance is r + s; of a graze the foot's."""
        which = bands.meets(self.line)
        return self.line.root(which[0]) if which else None
