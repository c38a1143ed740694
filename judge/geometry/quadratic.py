"""A line or a motion f + t·d past a circle or a sphere of radius r about the origin, in integers.

With a = d·d, b = f·d and c = f·f − r², the parameters of the common points are (−b ± √Δ)/a with Δ = b² − a·c.
By Lagrange's identity the line's distance from the origin is √((a·f·f − b²)/a), in the plane and in space.
A common point is named by `which`: -1 the first and 1 the second in order of t, 0 a touch or the foot of the
perpendicular from the origin. The circle's centre is the origin here, and anywhere in the answers.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import isqrt

from judge.exact.signs import root_sign
from judge.exact.surd import integers, make
from judge.geometry.sure import DecisionWords, Sure
from judge.values.answers import Real

Number = int | float
Point = tuple[Number, Number]
Vector = tuple[Real, ...]

LEAST_RADIUS = 10_000  # a radius that answers are divided by is 0, or at least size/LEAST_RADIUS


def on_circle(point: str, figure: str = "the circle") -> DecisionWords:
    """The words of whether that point is on the figure."""
    own = (
        f"{point[0].lower()}{point[1:]}" if " " in point else point
    )  # within a sentence: "a corner", but "A"
    sides = f"{own} is inside {figure}", f"{own} is exactly on {figure}", f"{own} is outside {figure}"
    return DecisionWords(
        f"{point} is almost on {figure}", "It must be exactly on it, or stay at least 1e-7·e away.", sides
    )


def tangent(line: str, of: str = "the circle") -> DecisionWords:
    """The words of whether that line touches."""
    told = line[0].lower() + line[1:]
    return DecisionWords(
        f"{line} is almost a tangent",
        "It must touch exactly, or stay at least 1e-7·e away.",
        (f"{told} cuts {of}", f"{told} touches {of} exactly", f"{told} misses {of}"),
    )


TANGENT = tangent("The line")
ORIGIN = on_circle("O"), on_circle("O + D")


class Quadratic:
    """f + t·d and the radius r >= 0, which decides by `sure`; the same in two and in three dimensions.

    There is no line where `a` is 0: `meets` then is empty, and the point 0 is f. A decision is made when it
    is asked for first, and raises InvalidCase where it is neither exact nor clear. `real_point`, `normal` and
    `time` raise ValueError for which = ±1 where there is no such point.

    Attributes:
        touch: the words of whether the line touches.
        ends: the words of whether f and f + d are on the circle.
        centre: the circle's centre in the answers.
        shift: a length of 1 in the answers is 2**shift here.
    """

    touch = TANGENT
    ends = on_circle("The start"), on_circle("The end")

    def __init__(
        self,
        f: Sequence[int],
        d: Sequence[int],
        r: int,
        sure: Sure,
        *,
        centre: Sequence[int] | None = None,
        shift: int = 0,
        ends: tuple[DecisionWords, DecisionWords] | None = None,
    ) -> None:
        if r < 0:
            raise ValueError("the radius is negative")
        a = b = square = 0
        for x, y in zip(f, d, strict=True):
            a += y * y
            b += x * y
            square += x * x
        self.f, self.d, self.r, self.sure, self.shift = f, d, r, sure, shift
        self.ends = ends or self.ends
        self.centre = [0] * len(f) if centre is None else centre
        self.a, self.b, self.square = a, b, square
        self.delta = b * b - a * (square - r * r)
        self._meets: tuple[int, ...] | None = None
        self._sides: dict[int, int] = {}

    # -- decisions -----------------------------------------------------------------------------------

    def meets(self) -> tuple[int, ...]:
        """The common points with the whole line, in order of t."""
        if self._meets is None:
            if self.a == 0:
                self._meets = ()
            else:
                across = self.a * self.square - self.b * self.b
                gap = self.sure.distance(across, self.r, self.a, what=self.touch)
                self._meets = ((-1, 1), (0,), ())[gap + 1]
        return self._meets

    def side(self, t: int = 0) -> int:
        """Where f (t = 0) or f + d (t = 1) is: -1 inside, 0 on the circle, 1 outside."""
        found = self._sides.get(t)
        if found is None:
            square = self.square + t * (2 * self.b + self.a)
            found = self._sides[t] = self.sure.distance(square, self.r, what=self.ends[t])
        return found

    def beside(self, which: int, t: int) -> int:
        """The sign of a common point's parameter less t, t being 0 or 1.

        It is exact, and clear because `side(t)` is: no point of the circle is nearer than the circle.
        """
        self.side(t)
        return root_sign(-self.b - t * self.a, which, self.delta)

    def first(self) -> int | None:
        """The common point of least t >= 0; None for a miss or d = 0."""
        self.side()
        return next((which for which in self.meets() if self.beside(which, 0) >= 0), None)

    def hit(self) -> int | None:
        """`first` on a circle that has normals: None for r = 0, InvalidCase for r < size/10,000."""
        self.sure.least(self.r * self.r, LEAST_RADIUS, "The radius")
        which = self.first()
        return which if self.r else None

    def within(self) -> list[int]:
        """The common points with 0 <= t <= 1, in order of t; for d = 0 it is 0 where f is on the circle."""
        if self.a == 0:
            return [] if self.side() else [0]
        for t in (0, 1):
            self.side(t)
        return [which for which in self.meets() if self.beside(which, 0) >= 0 >= self.beside(which, 1)]

    # -- answers -------------------------------------------------------------------------------------

    def unit(self) -> Fraction:
        """The size e in the answers' unit of length."""
        return Fraction(self.sure.size, 1 << self.shift)

    def step(self) -> int:
        """The largest of d's parts, without sign."""
        return max(map(abs, self.d))

    def time_unit(self) -> Fraction:
        """e divided by the largest part of d: the unit of a parameter."""
        return Fraction(self.sure.size, self.step())

    def time(self, which: int) -> Real:
        """The parameter of a common point; its unit is e divided by the largest part of d."""
        p, q = self._root(which)
        return Real(make(p - self.b, q, self.delta, self.a), self.time_unit())

    def real_point(self, which: int) -> Vector:
        """A common point; its unit is e."""
        a, unit = self.a or 1, self.unit()
        bottom = a << self.shift
        return tuple(
            Real(make(c * a + p, q, self.delta, bottom), unit)
            for c, (p, q) in zip(self.centre, self.parts(which), strict=True)
        )

    def normal(self, which: int) -> Vector:
        """The unit vector from the centre to a common point; its unit is e/r. ZeroDivisionError for r = 0."""
        unit = Fraction(self.sure.size, self.r)
        bottom = (self.a or 1) * self.r
        return tuple(Real(make(p, q, self.delta, bottom), unit) for p, q in self.parts(which))

    def facing(self, which: int) -> Vector:
        """`normal` on the side that the line comes from: flipped where it leaves."""
        normal = self.normal(which)
        return tuple(Real(-part.x, part.unit) for part in normal) if which > 0 else normal

    def parts(self, which: int) -> list[tuple[int, int]]:
        """(p, q) for each coordinate (p + q·√Δ)/a of a common point as seen from the centre; f for a = 0.

        q is 0 where √Δ is a whole number.
        """
        if self.a == 0:
            return [(x, 0) for x in self.f]
        p, q = self._root(which)
        return [(self.a * x + (p - self.b) * y, q * y) for x, y in zip(self.f, self.d, strict=True)]

    def _root(self, which: int) -> tuple[int, int]:
        """which·√Δ as (p, q) of p + q·√Δ, with q = 0 where √Δ is a whole number."""
        if which == 0:
            return 0, 0
        if self.delta < 0 or self.a == 0:
            raise ValueError("the line does not meet the circle")
        root = isqrt(self.delta)
        return (which * root, 0) if root * root == self.delta else (0, which)


class Sphere(Quadratic):
    """The sphere (C, r) and the ray O + t·D in space; e = max(r, |O − C|∞)."""

    ends = on_circle("O", "the sphere"), on_circle("O + D", "the sphere")

    def __init__(
        self, centre: Sequence[Number], radius: Number, origin: Sequence[Number], direction: Sequence[Number]
    ) -> None:
        numbers, shift = integers(*centre, radius, *origin, *direction)
        f = [numbers[4 + i] - numbers[i] for i in range(3)]
        size = max(numbers[3], *map(abs, f))
        super().__init__(f, numbers[7:], numbers[3], Sure(size), centre=numbers[:3], shift=shift)
