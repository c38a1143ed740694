"""A circle and a directed line in scaled integers: how often they meet, where, and at which parameter.

With D the direction, f = A − C, a = D·D, b = f·D and k = D × f, Lagrange's identity gives the discriminant
as Δ = b² − a(f·f − r²) = r²a − k², and the common points as C + (k·n ± √Δ·D)/a with n = (−dy, dx); their
parameters along A + t·D are (−b ± √Δ)/a.
"""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

from msgspec import Struct

from judge.exact.dyadic import integers
from judge.exact.surd import Surd, make

Number = int | float
Pair = tuple[Number, Number]


class CircleLine(Struct, frozen=True):
    """A circle (C, r) and the line A + t·D, every length an integer that counts units of 2**-shift.

    Build it with `through` or `ray`. `extent` is the case's own size e. The line is `degenerate` where D = 0.
    `root` and `point` take `which` = -1 or +1 for the first or second common point in order of t, 0 for
    the foot of the perpendicular from C.
    """

    cx: int
    cy: int
    r: int
    ax: int
    ay: int
    dx: int
    dy: int
    shift: int
    extent: int
    a: int
    b: int
    k: int
    delta: int

    @classmethod
    def through(cls, cx: Number, cy: Number, r: Number, start: Pair, end: Pair) -> CircleLine:
        """The line from A = `start` (t = 0) to B = `end` (t = 1); e = max(r, |A − C|∞, |B − C|∞).

        Raises ValueError for nan, infinities and r < 0, TypeError for what is neither int nor float.
        """
        (icx, icy, ir, ax, ay, bx, by), shift = integers(cx, cy, r, *start, *end)
        reach = max(ir, abs(ax - icx), abs(ay - icy), abs(bx - icx), abs(by - icy))
        return _build((icx, icy, ir), (ax, ay), (bx - ax, by - ay), shift, reach)

    @classmethod
    def ray(cls, cx: Number, cy: Number, r: Number, origin: Pair, direction: Pair) -> CircleLine:
        """The line O + t·D; e = max(r, |O − C|∞). Raises as `through` does."""
        (icx, icy, ir, ox, oy, dx, dy), shift = integers(cx, cy, r, *origin, *direction)
        reach = max(ir, abs(ox - icx), abs(oy - icy))
        return _build((icx, icy, ir), (ox, oy), (dx, dy), shift, reach)

    @classmethod
    def scaled(
        cls,
        circle: tuple[int, int, int],
        start: tuple[int, int],
        direction: tuple[int, int],
        shift: int,
        extent: int,
    ) -> CircleLine:
        """The line of numbers that are integers already: (cx, cy, r), A, D. ValueError for r < 0."""
        return _build(circle, start, direction, shift, extent)

    @property
    def degenerate(self) -> bool:
        """Whether D = (0, 0): no line at all."""
        return self.a == 0

    def count(self) -> int | None:
        """0, 1 or 2 common points of the circle and the line, exactly; None where there is no line."""
        if self.a == 0:
            return None
        return 1 if self.delta == 0 else (2 if self.delta > 0 else 0)

    def root(self, which: int) -> Surd:
        """The parameter t of a common point or (which = 0) of the foot; 0 for a degenerate line.

        Raises ValueError where which = ±1 and the line misses the circle.
        """
        if self.a == 0:
            return make(0, 0, 0, 1)
        p, q = self._fold(which)
        return make(p - self.b, q, self.delta, self.a)

    def point(self, which: int) -> tuple[Surd, Surd]:
        """The point's coordinates in the caller's units; A itself for a degenerate line. Raises as `root`."""
        if self.a == 0:
            unit = 1 << self.shift
            return make(self.ax, 0, 0, unit), make(self.ay, 0, 0, unit)
        p, q = self._fold(which)
        bottom = self.a << self.shift
        x = self.cx * self.a - self.k * self.dy
        y = self.cy * self.a + self.k * self.dx
        return (
            make(x + p * self.dx, q * self.dx, self.delta, bottom),
            make(y + p * self.dy, q * self.dy, self.delta, bottom),
        )

    def touching(self, which: int) -> tuple[Surd, Surd]:
        """Where a line through A touches the circle, in the caller's units: C + (r²f ± r√(f·f − r²)·n)/f·f.

        n is f = A − C turned to the left, and `which` the sign; 0 is A itself, and C where r = 0. Raises
        ValueError where which = ±1 and A is inside.
        """
        fx, fy, unit = self.ax - self.cx, self.ay - self.cy, 1 << self.shift
        if which == 0:
            x, y = (self.ax, self.ay) if self.r else (self.cx, self.cy)
            return make(x, 0, 0, unit), make(y, 0, 0, unit)
        square, inverse, reach = fx * fx + fy * fy, self.r * self.r, which * self.r
        over = square - inverse
        return (
            Surd(self.cx * square + inverse * fx, -reach * fy, over, square * unit),
            Surd(self.cy * square + inverse * fy, reach * fx, over, square * unit),
        )

    def outward(self, which: int) -> tuple[Surd, Surd]:
        """The unit vector from C to the point, (k·n + which·√Δ·D)/(a·r), or to a foot beside C, ±n/√a.

        Raises as `root` does, and ZeroDivisionError for r = 0 or a degenerate line.
        """
        if which == 0:
            x, y = self.left_normal()
            return (x, y) if self.k >= 0 else (-x, -y)
        p, q = self._fold(which)
        bottom = self.a * self.r
        return (
            Surd(p * self.dx - self.k * self.dy, q * self.dx, self.delta, bottom),
            Surd(p * self.dy + self.k * self.dx, q * self.dy, self.delta, bottom),
        )

    def facing(self, which: int) -> tuple[Surd, Surd]:
        """The unit normal at the point on the side that the line comes from: inward where it leaves."""
        x, y = self.outward(which)
        return (-x, -y) if which > 0 else (x, y)

    def reflected(self, which: int) -> tuple[Surd, Surd]:
        """D − 2(D·N)N at the point, N being the normal there: D·(1 − 2Δ/(a·r²)) − 2·which·k·√Δ/(a·r²)·n.

        At a foot that is D itself. In the caller's units; raises as `outward` does.
        """
        if which == 0:
            return make(self.dx, 0, 0, 1 << self.shift), make(self.dy, 0, 0, 1 << self.shift)
        p, q = self._fold(which)
        whole = self.a * self.r * self.r
        along, across = whole - 2 * self.delta, -2 * self.k
        x, y = along * self.dx - across * p * self.dy, along * self.dy + across * p * self.dx
        bottom = whole << self.shift
        return (
            Surd(x, -across * q * self.dy, self.delta, bottom),
            Surd(y, across * q * self.dx, self.delta, bottom),
        )

    def distance(self) -> Surd:
        """|k|/|D|, the distance of C from the line, in the caller's units; 0 for a degenerate line."""
        return Surd(0, abs(self.k), self.a, self.a << self.shift) if self.a else make(0, 0, 0, 1)

    def chord(self) -> Surd:
        """2√Δ/|D|, how much of the line the circle holds, in the caller's units; ValueError for a miss."""
        return Surd(0, 2, self.delta * self.a, self.a << self.shift) if self.delta else make(0, 0, 0, 1)

    def left_normal(self) -> tuple[Surd, Surd]:
        """The unit vector on the left of D, (−dy, dx)/|D|. Raises ZeroDivisionError for a degenerate line."""
        return Surd(0, -self.dy, self.a, self.a), Surd(0, self.dx, self.a, self.a)

    def height(self) -> Surd:
        """The signed distance of C from the line, positive on the left of D. Raises as `left_normal`."""
        return Surd(0, -self.k, self.a, self.a << self.shift)

    def extent_length(self) -> Surd:
        """The extent e in the caller's units."""
        return make(self.extent, 0, 0, 1 << self.shift)

    def small(self, least: Fraction) -> str | None:
        """What is wrong with a radius that is less than that part of the extent, and not 0; or None."""
        if 0 < self.r < least * self.extent:
            return "the radius is not 0, but too small a part of the extent"
        return None

    def _fold(self, which: int) -> tuple[int, int]:
        """which·√Δ as (p, q) of p + q·√Δ, with q = 0 where Δ is a perfect square."""
        if which not in (-1, 0, 1):
            raise ValueError(f"which is -1, 0 or 1, not {which}")
        if which == 0:
            return 0, 0
        if self.delta < 0:
            raise ValueError("the line misses the circle")
        root = isqrt(self.delta)
        return (which * root, 0) if root * root == self.delta else (0, which)


def _build(
    circle: tuple[int, int, int],
    start: tuple[int, int],
    direction: tuple[int, int],
    shift: int,
    extent: int,
) -> CircleLine:
    (cx, cy, r), (ax, ay), (dx, dy) = circle, start, direction
    if r < 0:
        raise ValueError("the radius is negative")
    fx, fy = ax - cx, ay - cy
    a = dx * dx + dy * dy
    k = dx * fy - dy * fx
    return CircleLine(
        cx, cy, r, ax, ay, dx, dy, shift, extent, a, fx * dx + fy * dy, k, r * r * a - k * k
    )  # fmt: skip
