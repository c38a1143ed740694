"""A circle with a line, a segment, a ray or a point, and every answer about them.

With f = A − C, D the direction, a = D·D and k = D × f: the distance of C from the line is |k|/√a, the chord
2√Δ/√a, and the discriminant Δ = r²a − k² (Lagrange's identity).
"""

from __future__ import annotations

from fractions import Fraction

from judge.exact.surd import Surd, integers, make
from judge.geometry.quadratic import LEAST_RADIUS, ORIGIN, Number, Point, Quadratic, Vector, on_circle
from judge.geometry.sure import Sure
from judge.values.answers import Real

_A_AND_B = on_circle("A"), on_circle("B")
_POINT = on_circle("P"), on_circle("P")


class Line(Quadratic):
    """A circle (C, r) and A + t·D; coordinates and lengths of the answers are the caller's.

    Build it with `through`, `ray` or `point`, which raise ValueError for nan, infinities and r < 0. Common
    points are named as in `Quadratic`.
    """

    @classmethod
    def through(cls, cx: Number, cy: Number, r: Number, A: Point, B: Point) -> Line:
        """The line from A (t = 0) to B (t = 1); e = max(r, |A − C|∞, |B − C|∞)."""
        (x, y, radius, ax, ay, bx, by), shift = integers(cx, cy, r, *A, *B)
        size = max(radius, abs(ax - x), abs(ay - y), abs(bx - x), abs(by - y))
        f, d = (ax - x, ay - y), (bx - ax, by - ay)
        return cls(f, d, radius, Sure(size), centre=(x, y), shift=shift, ends=_A_AND_B)

    @classmethod
    def ray(cls, cx: Number, cy: Number, r: Number, O: Point, D: Point) -> Line:
        """The ray O + t·D; e = max(r, |O − C|∞), and D has no part in it."""
        (x, y, radius, ox, oy, *d), shift = integers(cx, cy, r, *O, *D)
        f = (ox - x, oy - y)
        sure = Sure(max(radius, *map(abs, f)))
        return cls(f, d, radius, sure, centre=(x, y), shift=shift, ends=ORIGIN)

    @classmethod
    def point(cls, cx: Number, cy: Number, r: Number, P: Point) -> Line:
        """The point P, and no line; e = max(r, |P − C|∞)."""
        line = cls.ray(cx, cy, r, P, (0, 0))
        line.ends = _POINT
        return line

    @property
    def cross(self) -> int:
        """k = D × f: above 0 where C is on the right of the line."""
        return self.d[0] * self.f[1] - self.d[1] * self.f[0]

    # -- a line ----------------------------------------------------------------------------------------

    def count(self) -> int | None:
        """How many points the circle and the whole line have in common; None where there is no line."""
        return len(self.meets()) if self.a else None

    def points(self) -> list[Vector] | None:
        """Those points in order of t; None where there is no line."""
        return [self.real_point(which) for which in self.meets()] if self.a else None

    def chord(self) -> Real | None:
        """The length of the line in the circle, 0 for a touch; None for a miss or no line."""
        if not self.meets():
            return None
        return Real(Surd(0, 2, self.delta * self.a, self.a << self.shift), self.unit())

    def distance(self) -> Real | None:
        """The distance of C from the line; None where there is no line."""
        if not self.a:
            return None
        return Real(Surd(0, abs(self.cross), self.a, self.a << self.shift), self.unit())

    def foot(self) -> tuple[Real, Vector] | None:
        """t and the place of the foot of the perpendicular from C; None where there is no line."""
        return (self.time(0), self.real_point(0)) if self.a else None

    def normal_form(self) -> tuple[Real, Real, Real] | None:
        """The left unit normal's two parts, of unit 1, and C's signed distance, above 0 on the left.

        None where there is no line.
        """
        if not self.a:
            return None
        x, y = (Surd(0, part, self.a, self.a) for part in (-self.d[1], self.d[0]))
        height = Surd(0, -self.cross, self.a, self.a << self.shift)
        return Real(x, 1), Real(y, 1), Real(height, self.unit())

    # -- a ray and a point -------------------------------------------------------------------------------

    def reflected(self, which: int) -> Vector:
        """D − 2(D·N)N at a common point, N the normal there; its unit is e/r·|D|∞, and r is not 0.

        N = (f·a + (±√Δ − b)·D)/(a·r) and D·N = ±√Δ/r.
        """
        unit = Fraction(self.sure.size * self.step(), self.r << self.shift)
        bottom = self.a * self.r * self.r
        if which == 0:  # a touch
            return tuple(Real(make(x, 0, 0, 1 << self.shift), unit) for x in self.d)
        root, irrational = self._root(which)
        found = []
        for x, (p, q) in zip(self.d, self.parts(which), strict=True):
            # (p + q√Δ)·(root + irrational·√Δ), of which either q and irrational or root are 0
            whole, part = p * root + q * irrational * self.delta, p * irrational
            found.append(
                Real(make(x * bottom - 2 * whole, -2 * part, self.delta, bottom << self.shift), unit)
            )
        return tuple(found)

    def tangents(self) -> list[Vector]:
        """Where lines through A touch the circle, first the point on the left of A→C.

        With square = f·f they are C + (r²f ∓ r√(square − r²)·n)/square, n being f turned to the left. None
        for A inside; A itself on the circle; C for r = 0. InvalidCase for a small radius.
        """
        self.sure.least(self.r * self.r, LEAST_RADIUS, "The radius")
        side, unit, bottom = self.side(), self.unit(), 1 << self.shift
        if side < 0:
            return []
        if side == 0 or self.r == 0:
            return [
                tuple(
                    Real(make(c + (self.r and x), 0, 0, bottom), unit)
                    for c, x in zip(self.centre, self.f, strict=True)
                )
            ]
        (cx, cy), (fx, fy), square, whole = self.centre, self.f, self.square, self.r * self.r
        over, bottom = square - whole, square << self.shift
        return [
            (
                Real(Surd(cx * square + whole * fx, -reach * fy, over, bottom), unit),
                Real(Surd(cy * square + whole * fy, reach * fx, over, bottom), unit),
            )
            for reach in (-self.r, self.r)
        ]
