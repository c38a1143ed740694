"""Exact answers without any tolerance: signs, counts and roots of numbers just as they are, of any size.

Nothing here needs a promise; InvalidCase is raised only where a statement keeps a case out, such as A == B.
"""

from __future__ import annotations

from fractions import Fraction
from functools import partial

from msgspec import Struct

from judge.exact.signs import sign
from judge.exact.surd import Surd, integers
from judge.problem.declare import InvalidCase
from judge.values.answers import Judged, Real
from judge.values.wire import near

Number = int | float
Whole = tuple[int, int]

_LEAST, _MOST = Fraction(1, 10**300), 10**300  # of a root that is not 0


# -- first steps: whole numbers -----------------------------------------------------------------------


def square(p: Whole, q: Whole) -> int:
    """|q − p|²."""
    return (q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2


def cross(a: Whole, b: Whole, p: Whole) -> int:
    """(b − a) × (p − a), above 0 where p is on the left of a→b. InvalidCase for a == b."""
    distinct(a, b)
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def dot(a: Whole, b: Whole, p: Whole) -> int:
    """(a − p)·(b − p), below 0 where p is inside the circle with the diameter ab. InvalidCase for a == b.

    Source: Thales' theorem.
    """
    distinct(a, b)
    return (a[0] - p[0]) * (b[0] - p[0]) + (a[1] - p[1]) * (b[1] - p[1])


def axis_foot(a: Whole, b: Whole, p: Whole) -> Whole:
    """The foot of the perpendicular from p on the horizontal or vertical line ab. Raises InvalidCase."""
    distinct(a, b)
    if a[1] == b[1]:
        return p[0], a[1]
    if a[0] == b[0]:
        return a[0], p[1]
    raise InvalidCase("The line is neither level nor upright.")


def distinct(a: Whole, b: Whole) -> None:
    """InvalidCase for a == b, coordinate by coordinate."""
    if a[0] == b[0] and a[1] == b[1]:
        raise InvalidCase("A and B are the same point.")


# -- a circle and a line -----------------------------------------------------------------------------


class Discriminant(Struct, frozen=True):
    """Δ = r²·a − k² of a circle and the line through A and B: 0 for A == B.

    Integers that count units: `reach` is r²·a, `k` the cross product D × f for D = B − A and f = A − C,
    `whole` M = |dx·fy| + |dy·fx|. One unit of r²·a, k² and M² is `unit`.
    """

    reach: int
    k: int
    whole: int
    unit: Fraction

    @property
    def sign(self) -> int:
        """The sign of Δ: -1 where the line misses the circle, 0 for a touch or A == B, 1 where it cuts."""
        return sign(self.reach - self.k * self.k)

    @property
    def value(self) -> Fraction:
        """Δ in the caller's numbers."""
        return (self.reach - self.k * self.k) * self.unit

    @property
    def width(self) -> Fraction:
        """2⁻⁴⁶·(r²a + M·|k|) + 2⁻⁹⁸·M², about a hundred roundings of each term in doubles."""
        terms = Fraction(self.reach + self.whole * abs(self.k), 1 << 46)
        return (terms + Fraction(self.whole**2, 1 << 98)) * self.unit


def discriminant(*seven: Number) -> Discriminant:
    """The discriminant for cx, cy, r, ax, ay, bx, by as they are. ValueError for nan and infinities."""
    (x, y, radius, x1, y1, x2, y2), shift = integers(*seven)
    dx, dy, fx, fy = x2 - x1, y2 - y1, x1 - x, y1 - y
    right, left = dx * fy, dy * fx
    reach = radius * radius * (dx * dx + dy * dy)
    return Discriminant(reach, right - left, abs(right) + abs(left), Fraction(1, 1 << 4 * shift))


def enclosure(x: Fraction, width: Fraction) -> Judged:
    """Any (lo, hi) with lo <= x <= hi and hi - lo <= width."""
    ends = Surd.of(x).round_down(), Surd.of(x).round_up()
    return Judged(partial(_no_enclosure, x, width), tuple(Real(Fraction(end)) for end in ends))


def _no_enclosure(x: Fraction, width: Fraction, ends: tuple[Number, Number], _group: str) -> str | None:
    low, high = map(Fraction, ends)
    if low > high:
        return "lo is above hi"
    if not low <= x <= high:
        return f"{'lo is above' if low > x else 'hi is below'} the exact number, {float(x)!r}"
    if high - low > width:
        return f"it is {near(high - low):.3g} wide, {near(width):.3g} is allowed"
    return None


def count_line(cx: int, cy: int, r: int, a: Whole, b: Whole) -> int | None:
    """How many points the circle and the line through a and b have in common; None for a == b."""
    if a[0] == b[0] and a[1] == b[1]:
        return None
    return 1 + discriminant(cx, cy, r, *a, *b).sign


def count_segment(cx: int, cy: int, r: int, a: Whole, b: Whole) -> int:
    """How many points the circle and the closed segment ab have in common.

    By the sides of both ends, Δ, and whether the foot of the perpendicular from C is between the ends.
    """
    centre, length = (cx, cy), square(a, b)
    to_a, to_b = square(centre, a), square(centre, b)
    first, last = sign(to_a - r * r), sign(to_b - r * r)
    if length == 0:
        return int(first == 0)
    delta = discriminant(cx, cy, r, *a, *b).sign
    between = 0 <= to_a - dot(a, b, centre) <= length  # the foot: −f·D of D·D
    if delta <= 0:
        return int(delta == 0 and between)
    if first < 0 or last < 0:  # the line leaves the circle on each side of what is inside
        return int(first >= 0) + int(last >= 0)
    if between:  # the foot is inside and neither end is
        return 2
    return int(first == 0) + int(last == 0)


# -- a quadratic equation --------------------------------------------------------------------------------


def roots(a: Number, b: Number, c: Number) -> list[Real] | None:
    """The real roots of a·t² + 2·b·t + c = 0 in ascending order, a double one once; None for 0 = 0.

    InvalidCase for an int that no double holds, and for a root other than 0 beyond 1e-300 … 1e300.
    """
    (m, n, k), _ = integers(*held(a, b, c))
    if m == 0:
        if n == 0:
            return [] if k else None
        found = [Surd(-k, 0, 0, 2 * n)]
    else:
        delta, side = n * n - m * k, sign(m)
        signs = (-side, side) if delta > 0 else ((0,) if delta == 0 else ())
        found = [Surd(-n, which, delta if which else 0, m) for which in signs]
    if any(x.sign() and not _LEAST <= abs(x) <= _MOST for x in found):
        raise InvalidCase("A root is beyond the range of doubles.")
    return [Real(x) for x in found]


def held(*numbers: Number) -> tuple[Number, ...]:
    """The numbers as they are. InvalidCase for an int that no double holds."""
    if any(type(number) is int and _rounds(number) for number in numbers):
        raise InvalidCase("No double holds one of the numbers.")
    return numbers


def _rounds(number: int) -> bool:
    """Whether its significant bits are more than a double has, or it is too large for one."""
    bits = abs(number).bit_length()
    return bits > 1024 or (number != 0 and bits - ((number & -number).bit_length() - 1) > 53)
