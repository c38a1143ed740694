"""A disc that moves evenly and a wall that stands, in scaled integers: when the disc touches it.

The disc touches the segment AB where P is on the wall fattened by r: two sides beside it, and a cap around
each end. With D = P1 − P0, W = B − A, w = W·W and k = W × (P0 − A), a side is met at the time
(−k ± r√w)/(W × D); a cap, as any circle is by a ray.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from msgspec import Struct
from msgspec.structs import replace

from judge.exact.dyadic import integers
from judge.exact.signs import root_sign
from judge.exact.surd import Surd
from judge.topics.circles.bands import Bands
from judge.topics.circles.line import CircleLine, Number, Pair
from judge.topics.circles.motion.moments import Pace
from judge.topics.circles.plane import IntPoint


class Wall(Struct, frozen=True):
    """The disc (P, r) from its place at t = 0 to that at t = 1, and the wall AB, in units of 2**-shift.

    `caps` are the circles of radius r about A and B with the line that P moves along; their extent is that of
    the case, e = max(r, |A − P0|∞, |A − P1|∞, |B − P0|∞, |B − P1|∞).
    """

    p: tuple[IntPoint, IntPoint]
    wall: tuple[IntPoint, IntPoint]
    r: int
    caps: tuple[CircleLine, CircleLine]

    @classmethod
    def of(cls, p0: Pair, p1: Pair, r: Number, a: Pair, b: Pair) -> Wall:
        """The disc and the wall of a case. Raises ValueError for nan, infinities and a radius below 0."""
        (px, py, qx, qy, ax, ay, bx, by, radius), shift = integers(*p0, *p1, *a, *b, r)
        if radius < 0:
            raise ValueError("the radius is negative")
        spans = [end - place for end in (ax, bx) for place in (px, qx)]
        spans += [end - place for end in (ay, by) for place in (py, qy)]
        extent = max(radius, *map(abs, spans))
        caps = tuple(
            replace(CircleLine.ray(*end, radius, (px, py), (qx - px, qy - py)), shift=shift, extent=extent)
            for end in ((ax, ay), (bx, by))
        )
        return cls(((px, py), (qx, qy)), ((ax, ay), (bx, by)), radius, caps)  # type: ignore[arg-type]  # two

    @property
    def extent(self) -> int:
        """The case's own size e."""
        return self.caps[0].extent

    @property
    def way(self) -> IntPoint:
        """D, the disc's motion."""
        return self.caps[0].dx, self.caps[0].dy

    @property
    def along(self) -> IntPoint:
        """W, the wall from A to B."""
        (ax, ay), (bx, by) = self.wall
        return bx - ax, by - ay

    @property
    def turn(self) -> int:
        """W × D: 0 where the disc moves along the wall, or either is a point."""
        (wx, wy), (dx, dy) = self.along, self.way
        return wx * dy - wy * dx

    @property
    def pace(self) -> Pace:
        """How the moments of this case are told apart."""
        return Pace(self.extent, max(map(abs, self.way)))

    def apart(self, t: Fraction | int) -> Fraction:
        """The squared distance of P from the wall at a moment."""
        (px, py), (dx, dy) = self.p[0], self.way
        (ax, ay), (wx, wy) = self.wall[0], self.along
        x, y = px + t * dx - ax, py + t * dy - ay
        square, foot = wx * wx + wy * wy, x * wx + y * wy
        if not square or foot <= 0:
            return Fraction(x * x + y * y)
        if foot >= square:
            return Fraction((x - wx) ** 2 + (y - wy) ** 2)
        return Fraction((wx * y - wy * x) ** 2, square)

    @property
    def start(self) -> Fraction:
        """The squared distance at the start."""
        return self.apart(0)

    @property
    def least(self) -> Fraction:
        """The least squared distance of the wall from the line that P moves along; the way must be one."""
        one, other = (cap.k for cap in self.caps)
        if (one > 0) != (other > 0) or not one or not other:
            return Fraction(0)
        return Fraction(min(one * one, other * other), self.caps[0].a)

    def beside(self, square: Fraction, bands: Bands) -> int:
        """Whether √square is less than r (-1), more (1), or the same within the band (0)."""
        return bands.beside(*self.scaled(square))

    def scaled(self, square: Fraction) -> tuple[int, int, int]:
        """√square, squared, and r and e in a unit in which all of them are whole."""
        unit = square.denominator  # √(n/m) is √(n·m)/m
        return square.numerator * unit, self.r * unit, self.extent * unit

    def first(self, bands: Bands) -> Surd | None:
        """The first touch anywhere on the line that P moves along; of a graze the foot's."""
        if not self.caps[0].a:
            return None
        side = self.beside(self.least, bands)
        if side > 0:
            return None
        touched = [bands.count(cap) == 1 for cap in self.caps]
        if side == 0:  # the line goes past one end, or both of them
            found = [cap.root(0) for cap, on in zip(self.caps, touched, strict=True) if on]
        else:
            found = [
                cap.root(-1) for cap, on in zip(self.caps, touched, strict=True) if not on and cap.delta > 0
            ]
            found += self._sides()
        return min(found, default=None)

    def _sides(self) -> Iterator[Surd]:
        """The moments at which P is r beside the wall, between its ends."""
        turn = self.turn
        if not turn:
            return
        (px, py), (dx, dy) = self.p[0], self.way
        (ax, ay), (wx, wy) = self.wall[0], self.along
        x, y = px - ax, py - ay
        square, foot, pace = wx * wx + wy * wy, x * wx + y * wy, dx * wx + dy * wy
        for side in (-1, 1):
            # t = (p + q√w)/m
            p, q, m = wy * x - wx * y, side * self.r, turn
            if m < 0:
                p, q, m = -p, -q, -m
            before, after = foot * m + pace * p, foot * m + pace * p - square * m
            if root_sign(before, pace * q, square) >= 0 >= root_sign(after, pace * q, square):
                yield Surd(p, q, square, m)
