"""Many circles and one ray, in scaled integers: every hit in order of t, and which of them are at one place.

With D the direction, a = D·D is the same for all circles. A hit's parameter is u/a with u = −b ± √Δ, so hits
are told apart by u alone. Two of them, or one and the origin, are at one place where |Δt|·|D|∞ is at most
snap·e; e is the largest of all radii and of all |C − O|∞.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain
from math import isqrt

from msgspec import Struct

from judge.exact.dyadic import integers
from judge.exact.signs import two_root_sign
from judge.exact.surd import Surd, make
from judge.topics.circles.bands import Bands
from judge.topics.circles.line import CircleLine, Number, Pair

Circle = tuple[Number, Number, Number]

_BITS = 64  # of u that are computed below the unit, to tell most hits apart without a root
_ERROR = 3  # units of the last of them, in the difference of two


class Hit(Struct, frozen=True):
    """One hit: u = p + q·√d, about `near` units of 2**-64; the circle's index; the side of it.

    `side` is -1 where the ray enters the circle, 0 where it touches it, 1 where it leaves.
    """

    near: int
    p: int
    q: int
    d: int
    index: int = -1
    side: int = 0


_ORIGIN = Hit(0, 0, 0, 0)


class Crowd(Struct, frozen=True):
    """Circles (C, r) and the ray O + t·D, every length an integer that counts units of 2**-shift.

    `lines` are the circles one by one, with the ray and the extent of them all; `places` are further points.
    """

    lines: tuple[CircleLine, ...]
    origin: tuple[int, int]
    direction: tuple[int, int]
    shift: int
    extent: int
    places: tuple[tuple[int, int], ...] = ()

    @classmethod
    def of(cls, circles: Sequence[Circle], origin: Pair, direction: Pair, *others: Pair) -> Crowd:
        """The circles and the ray; `others` are points that the extent reaches to as well.

        Raises ValueError for nan, infinities and a radius below 0.
        """
        (ox, oy, dx, dy, *rest), shift = integers(*origin, *direction, *chain(*others), *chain(*circles))
        points, flat = rest[: 2 * len(others)], rest[2 * len(others) :]
        found = tuple(zip(flat[::3], flat[1::3], flat[2::3], strict=True))
        if any(r < 0 for _, _, r in found):
            raise ValueError("a radius is negative")
        xs, ys = (*flat[::3], *points[::2]), (*flat[1::3], *points[1::2])
        extent = max(*flat[2::3], *(abs(x - ox) for x in xs), *(abs(y - oy) for y in ys))
        lines = tuple(CircleLine.scaled(each, (ox, oy), (dx, dy), shift, extent) for each in found)
        places = tuple(zip(points[::2], points[1::2], strict=True))
        return cls(lines, (ox, oy), (dx, dy), shift, extent, places)

    @property
    def step(self) -> int:
        """|D|∞."""
        return max(map(abs, self.direction))

    def unit(self) -> Fraction:
        """e/|D|∞, the extent in terms of t."""
        return Fraction(self.extent, self.step or 1)

    def every_hit(self, bands: Bands) -> list[Hit]:
        """All hits of the whole line, in order of t; those at one place in some order."""
        found: list[Hit] = []
        for index, line in enumerate(self.lines):
            middle = -line.b << _BITS
            for side in bands.meets(line):
                if side == 0:
                    found.append(Hit(middle, -line.b, 0, 0, index))
                else:
                    near = middle + side * isqrt(line.delta << 2 * _BITS)
                    found.append(Hit(near, -line.b, side, line.delta, index, side))
        return sorted(found, key=lambda hit: hit.near)

    def ahead(self, every: Sequence[Hit], bands: Bands) -> list[Hit]:
        """Those of the hits with t >= 0, or at 0 by the band."""
        return [hit for hit in every if hit.near > 0 or self.at_origin(hit, bands)]

    def at_origin(self, hit: Hit, bands: Bands) -> bool:
        """Whether a hit is at t = 0 by the band."""
        return self.together(hit, _ORIGIN, bands.snap)

    def runs(self, hits: Sequence[Hit], bands: Bands) -> Iterator[list[Hit]]:
        """Hits in order, those at one place in a list of their own."""
        run: list[Hit] = []
        for hit in hits:
            if run and not self.together(hit, run[0], bands.snap):
                yield run
                run = []
            run.append(hit)
        if run:
            yield run

    def parameter(self, hit: Hit, bands: Bands) -> Surd:
        """The hit's t, exactly 0 at the origin."""
        if self.at_origin(hit, bands):
            return make(0, 0, 0, 1)
        return self.lines[hit.index].root(hit.side)

    def together(self, one: Hit, other: Hit, width: Fraction, *, strictly: bool = False) -> bool:
        """Whether |Δt|·|D|∞ is <= (or <) width·e."""
        a = self.lines[0].a
        top, bottom = width.numerator * self.extent * a, width.denominator * self.step
        apart, reach = abs(one.near - other.near), (top << _BITS) // (bottom or 1)
        if apart > reach + _ERROR:
            return False  # certified, as below: each `near` is off by less than a unit
        if apart < reach - _ERROR:
            return True
        p = one.p - other.p
        for side in (1, -1):  # top − bottom·side·(u − v)
            sign = two_root_sign(
                top - side * bottom * p, -side * bottom * one.q, one.d, side * bottom * other.q, other.d
            )
            if sign < 0 or (strictly and sign == 0):
                return False
        return True

    def gap(self, one: Hit, other: Hit) -> float:
        """|Δt|·|D|∞ in parts of the extent, to the last digits of a double unless it is tiny."""
        apart = Fraction(abs(one.near - other.near), 1 << _BITS)
        return float(apart * self.step / (self.lines[0].a * self.extent))
