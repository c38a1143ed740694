"""A sphere and a ray in scaled integers: where the ray meets it first, and the normal there.

With D the direction, f = O − C, a = D·D, b = f·D and d the distance of C from the line, Lagrange's identity
has |D × f|² = a·(f·f) − b² = a·d². So Δ = r²a − |D × f|², and the common points are at t = (−b ± √Δ)/a.
"""

from __future__ import annotations

from fractions import Fraction

from msgspec import Struct

from judge.exact.dyadic import integers
from judge.exact.signs import root_sign
from judge.exact.surd import Surd, make
from judge.topics.circles import Bands

Number = int | float
Triple = tuple[Number, Number, Number]
Whole = tuple[int, int, int]


class SphereRay(Struct, frozen=True):
    """A sphere (C, r) and the ray O + t·D, every length an integer that counts units of 2**-shift.

    `f` is O − C, `square` is |D × f|², `extent` the case's own size e = max(r, |O − C|∞). There is no ray
    where `a` is 0, and no sphere where `r` is.
    """

    f: Whole
    d: Whole
    r: int
    shift: int
    extent: int
    a: int
    b: int
    square: int
    delta: int

    @classmethod
    def of(cls, centre: Triple, radius: Number, origin: Triple, direction: Triple) -> SphereRay:
        """Those of a case. Raises ValueError for nan, infinities and a radius below 0."""
        (cx, cy, cz, r, ox, oy, oz, dx, dy, dz), shift = integers(*centre, radius, *origin, *direction)
        if r < 0:
            raise ValueError("the radius is negative")
        f, d = (ox - cx, oy - cy, oz - cz), (dx, dy, dz)
        a = dx * dx + dy * dy + dz * dz
        b = f[0] * dx + f[1] * dy + f[2] * dz
        square = a * (f[0] * f[0] + f[1] * f[1] + f[2] * f[2]) - b * b
        extent = max(r, abs(f[0]), abs(f[1]), abs(f[2]))
        return cls(f, d, r, shift, extent, a, b, square, r * r * a - square)

    @property
    def step(self) -> int:
        """|D|∞: what one unit of t is taken for where lengths along the ray are measured."""
        return max(map(abs, self.d))

    def beside(self, bands: Bands) -> int:
        """Whether the line cuts the sphere (-1), touches it within the band (0), or misses it (1)."""
        return bands.beside(self.square * self.a, self.r * self.a, self.extent * self.a)

    def meets(self, bands: Bands) -> tuple[int, ...]:
        """The common points of the sphere and the line in order of t, as `which` of `root`."""
        if self.a == 0 or self.r == 0:
            return ()
        return ((-1, 1), (0,), ())[self.beside(bands) + 1]

    def root(self, which: int) -> Surd:
        """The parameter of the first (-1) or second (1) common point; of the foot for 0."""
        return Surd(-self.b, which, self.delta, self.a) if which else make(-self.b, 0, 0, self.a)

    def at_origin(self, which: int, width: Fraction, *, strictly: bool = False) -> bool:
        """Whether that point is at most (or less than) `width` extents from O, |t|·|D|∞ being the length."""
        bound = width.numerator * self.extent * self.a
        step, under = width.denominator * self.step, self.delta if which else 0
        least = 1 if strictly else 0
        return all(
            root_sign(bound + sign * step * self.b, -sign * step * which, under) >= least for sign in (1, -1)
        )

    def first(self, bands: Bands) -> tuple[Surd, int] | None:
        """The least t ≥ 0 of a common point, exactly 0 at the origin, and its `which`; None for a miss."""
        for which in self.meets(bands):
            if self.at_origin(which, bands.snap):
                return make(0, 0, 0, 1), which
            t = self.root(which)
            if t.sign() > 0:
                return t, which
        return None

    def normal(self, which: int) -> tuple[Surd, ...]:
        """The unit normal that faces the ray: outward where it enters or touches, inward where it leaves."""
        if which == 0:  # C to the foot is (a·f − b·D)/a, and that is √(a·|D × f|²)/a long
            size = self.a * self.square
            return tuple(
                Surd(0, self.a * f - self.b * d, size, size) for f, d in zip(self.f, self.d, strict=True)
            )
        bottom = -which * self.a * self.r
        return tuple(
            Surd(self.a * f - self.b * d, which * d, self.delta, bottom)
            for f, d in zip(self.f, self.d, strict=True)
        )
