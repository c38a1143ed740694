"""What counts as a tangency, as an end of a segment and as a ray's origin, decided in integers.

With e the case's extent, d the distance of C from the line and two widths snap < clear:
|d − r| <= snap·e is a tangency at the foot of the perpendicular; a common point within snap·e beyond an end
of the segment is on it; one within snap·e of a ray's origin is at t = 0. The promise of a case is that no
such distance lies strictly between snap·e and clear·e.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache
from math import isqrt

from judge.exact.signs import two_root_sign
from judge.exact.surd import Surd, make
from judge.topics.circles.line import CircleLine


@dataclass(frozen=True, slots=True)
class Bands:
    """The two widths, 0 <= snap <= clear, in units of a case's extent; ValueError otherwise."""

    snap: Fraction
    clear: Fraction
    _snap: Width = field(init=False, repr=False, compare=False)
    _clear: Width = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        if not 0 <= self.snap <= self.clear:
            raise ValueError("the bands' widths are 0 <= snap <= clear")
        object.__setattr__(self, "_snap", Width.of(self.snap))
        object.__setattr__(self, "_clear", Width.of(self.clear))

    @staticmethod
    def of(widths: Mapping[str, Fraction]) -> Bands:
        """The bands that problem.toml names `snap` and `clear`."""
        snap, clear = widths["snap"], widths["clear"]
        return _bands(snap.numerator, snap.denominator, clear.numerator, clear.denominator)

    def count(self, line: CircleLine) -> int | None:
        """0, 1 or 2 common points of the circle and the infinite line; None where there is no line."""
        if line.a == 0:
            return None
        if self._snap.touches(line):
            return 1
        return 2 if line.delta > 0 else 0

    def side(self, line: CircleLine) -> int:
        """Where the line's point A is: -1 inside the circle, 0 on it, 1 outside."""
        if self._snap.starts_on_circle(line):
            return 0
        square = (line.ax - line.cx) ** 2 + (line.ay - line.cy) ** 2
        return 1 if square > line.r * line.r else -1

    def tangents(self, line: CircleLine) -> tuple[int, ...]:
        """The points where lines through the line's point A touch, as `which` of `CircleLine.touching`.

        -1 is on the left of A→C, 1 on its right; 0 is A itself on the circle, or the circle of radius 0.
        """
        if line.r == 0:
            return (0,)
        return ((), (0,), (-1, 1))[self.side(line) + 1]

    def segment(self, line: CircleLine) -> tuple[int, ...]:
        """The common points on the closed segment t = 0 … 1, in order of t, as `which` of `CircleLine.point`.

        -1 and +1 are the two roots, 0 a tangency's foot or the point A of a degenerate segment.
        """
        if line.a == 0:
            return (0,) if self._snap.starts_on_circle(line) else ()
        return tuple(which for which in self.meets(line) if self._on_segment(line, which))

    def ray(self, line: CircleLine) -> Surd | None:
        """The least t >= 0 of a common point, exactly 0 at the origin; None for a miss or D = 0."""
        which = self.hit(line)
        if which is None:
            return None
        return make(0, 0, 0, 1) if self._snap.within(line, which, 0) else line.root(which)

    def hit(self, line: CircleLine) -> int | None:
        """The common point that the ray meets first, as `which` of `CircleLine.point`: -1 enters, 1 leaves.

        None for a miss or D = 0.
        """
        for which in self.meets(line):
            if beyond(line, which, 0) > 0 or self._snap.within(line, which, 0):
                return which
        return None

    def end(self, line: CircleLine, which: int) -> int | None:
        """The end of the segment that the common point is at, 0 or 1; None where it is at neither."""
        if self._snap.clear_of_ends(line, which):
            return None
        return next((t for t in (0, 1) if self._snap.within(line, which, t)), None)

    def broken_count(self, line: CircleLine) -> str | None:
        """Why the case breaks the promise of a counting problem, for a person; None where it is kept."""
        if line.a == 0 or self._snap.touches(line) or not self._clear.nearly_touches(line):
            return None
        distance = Surd(-line.r * line.a, abs(line.k), line.a, line.a)
        return _inside_band("the line's distance to the circle", distance, line.extent)

    def broken_segment(self, line: CircleLine) -> str | None:
        """The same for a segment: the circle's tangency and each common point's distance to either end."""
        if line.a == 0:
            return self._broken_start(line)
        return self.broken_count(line) or self._broken_root(
            line, ((0, "the segment's start"), (1, "the segment's end"))
        )

    def broken_ray(self, line: CircleLine) -> str | None:
        """The same for a ray: the circle's tangency and each common point's distance to the origin."""
        if line.a == 0:
            return None
        return self.broken_count(line) or self._broken_root(line, ((0, "the ray's origin"),))

    def meets(self, line: CircleLine) -> tuple[int, ...]:
        """The common points of the circle and the infinite line, in order of t."""
        if line.a == 0:
            return ()
        if self._snap.touches(line):
            return (0,)
        return (-1, 1) if line.delta > 0 else ()

    def beside(self, square: int, radius: int, extent: int) -> int:
        """Whether √square is less than the radius (-1), more (1), or the same within snap·extent (0)."""
        if self._snap.close(square, radius, extent):
            return 0
        return 1 if square > radius * radius else -1

    def nearly(self, square: int, radius: int, extent: int) -> bool:
        """Whether |√square − radius| is less than clear·extent, or 0."""
        return square == radius * radius or self._clear.close(square, radius, extent, strictly=True)

    def _on_segment(self, line: CircleLine, which: int) -> bool:
        before = beyond(line, which, 0) < 0
        after = not before and beyond(line, which, 1) > 0
        if not before and not after:
            return True
        return self._snap.within(line, which, 1 if after else 0)

    def _broken_start(self, line: CircleLine) -> str | None:
        if self._snap.starts_on_circle(line) or not self._clear.starts_near_circle(line):
            return None
        square = (line.ax - line.cx) ** 2 + (line.ay - line.cy) ** 2
        return _inside_band("the point's distance to the circle", Surd(-line.r, 1, square, 1), line.extent)

    def _broken_root(self, line: CircleLine, ends: tuple[tuple[int, str], ...]) -> str | None:
        for which in self.meets(line):
            if self._clear.clear_of_ends(line, which):
                continue
            for t, name in ends:
                if not self._snap.within(line, which, t) and self._clear.within(
                    line, which, t, strictly=True
                ):
                    away = line.root(which) - t
                    # |away|·|D| needs two roots at once; a person reads its double.
                    length = abs(float(away)) * float(Surd(0, 1, line.a, line.extent))
                    return f"a common point's distance to {name} is {length:.2g} {_FORBIDDEN}"
        return None


@lru_cache(maxsize=8)  # every case of a problem asks for the same; ints, for hashing a Fraction takes long
def _bands(snap: int, per_snap: int, clear: int, per_clear: int) -> Bands:
    return Bands(Fraction(snap, per_snap), Fraction(clear, per_clear))


_FORBIDDEN = "of the extent, inside the forbidden band"


def _inside_band(what: str, distance: Surd, extent: int) -> str:
    return f"{what} is {float(abs(distance) / extent):.2g} {_FORBIDDEN}"


def beyond(line: CircleLine, which: int, t: int) -> int:
    """The sign of (the root's parameter − t), t being 0 or 1."""
    p = -line.b - t * line.a
    if which == 0:
        return (p > 0) - (p < 0)
    # p + which·√Δ: Δ > 0 here, or the line would not meet the circle twice.
    if p == 0 or (p > 0) == (which > 0):
        return which
    difference = p * p - line.delta
    outcome = (difference > 0) - (difference < 0)
    return outcome if p > 0 else -outcome


_MOST_BITS = 4096  # a band of width 0: only Δ = 0 or a tiny one is worth the exact test


@dataclass(frozen=True, slots=True)
class Width:
    """A band's half-width n/m in units of the extent, and a power of two above what it does to Δ."""

    n: int
    m: int
    bits: int

    @classmethod
    def of(cls, width: Fraction) -> Width:
        """The width of that share."""
        # |d − r| <= w·e with r <= e puts |Δ| at or below (2w + w²)·e²·a, and so below e²·a·2**-bits.
        spread = 2 * width + width * width
        if spread == 0:
            return cls(0, 1, _MOST_BITS)
        bits = (spread.denominator // spread.numerator).bit_length() - 1
        return cls(width.numerator, width.denominator, bits)

    def touches(self, line: CircleLine) -> bool:
        """Whether |d − r| <= w·e."""
        return self._close(line, 0)

    def nearly_touches(self, line: CircleLine) -> bool:
        """Whether |d − r| < w·e."""
        return self._close(line, 1)

    def _close(self, line: CircleLine, least: int) -> bool:
        """Whether |d − r| <= w·e (least 0) or < w·e (least 1), d being |k|/√a: k²m² against (mr ± ne)²a."""
        extent = line.extent
        if self.bits >= 0 and (extent * extent * line.a) >> self.bits < abs(line.delta):
            return False  # certified: |Δ| exceeds what any distance within the band allows
        width, radius = self.n * extent, self.m * line.r
        square = (self.m * line.k) ** 2
        if (radius + width) ** 2 * line.a - square < least:
            return False
        inner = radius - width
        return inner < 0 or square - inner * inner * line.a >= least

    def starts_on_circle(self, line: CircleLine) -> bool:
        """Whether ||A − C| − r| <= w·e."""
        return self._point_close(line, 0)

    def starts_near_circle(self, line: CircleLine) -> bool:
        """Whether ||A − C| − r| < w·e."""
        return self._point_close(line, 1)

    def _point_close(self, line: CircleLine, least: int) -> bool:
        square = (line.ax - line.cx) ** 2 + (line.ay - line.cy) ** 2
        return self.close(square, line.r, line.extent, strictly=least > 0)

    def close(self, square: int, radius: int, extent: int, *, strictly: bool = False) -> bool:
        """Whether |√square − radius| is <= (or <) w·extent."""
        least = 1 if strictly else 0
        square, width, radius = square * self.m**2, self.n * extent, self.m * radius
        if (radius + width) ** 2 - square < least:
            return False
        inner = radius - width
        return inner < 0 or square - inner * inner >= least

    def clear_of_ends(self, line: CircleLine, which: int) -> bool:
        """Whether the root is plainly farther than w·e from both ends; where it is False, `within` says."""
        reach = self.n * line.extent * (isqrt(line.a) + 1) // self.m + 2  # as there, and what isqrt leaves
        low = (which * isqrt(line.delta) if which else 0) - line.b
        return abs(low) > reach < abs(low - line.a)

    def within(self, line: CircleLine, which: int, t: int, *, strictly: bool = False) -> bool:
        """Whether the root's distance to the point of parameter `t`, along the line, is <= (or <) w·e.

        The root is (−b + which·√Δ)/a, so the distance is |u|/√a with u = −b − t·a + which·√Δ, against w·e·√a.
        """
        u = -line.b - t * line.a
        bound = self.n * line.extent
        reach = bound * (isqrt(line.a) + 1) // self.m + 1  # above w·e·√a
        low = u + (which * isqrt(line.delta) if which else 0)
        if low - 1 > reach or low + 1 < -reach:
            return False  # certified: u lies in [low − 1, low + 1]
        for side in (1, -1):
            # w·e·√a − side·u
            outcome = two_root_sign(
                -side * u * self.m, -side * which * self.m, line.delta if which else 0, bound, line.a
            )
            if outcome < 0 or (strictly and outcome == 0):
                return False
        return True
