"""Decisions about lengths that are exactly 0, or clear: at least 1e-7 of the figure's size.

A sign is exact. That a length is clear is certified by a lower bound, which costs less than to compare it
with the threshold; where the bound is below that, it is compared, by squaring. So a length of exactly the
threshold is clear.
"""

from __future__ import annotations

from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from math import isqrt
from typing import NamedTuple

from judge.exact.signs import root_sign, two_root_sign
from judge.problem.declare import InvalidCase, decided, refuse

CLEAR = 10_000_000  # a length that decides is 0, or at least size/CLEAR
BITS = 64  # below the figure's unit: how exactly a root's length is taken
_UNIT = 2 * BITS


Sides = tuple[str, str, str]  # of a length below 0, 0, and above 0


class DecisionWords(NamedTuple):
    """What is said of a decision: where its length is neither 0 nor clear, and what it came to."""

    almost: str  # without its full stop: "The line is almost a tangent"
    must: str  # "It must touch exactly, or stay at least 1e-7·e away."
    sides: Sides  # "the line cuts the circle", "the line touches it exactly", "the line misses it"

    @property
    def name(self) -> str:
        """The decision in a table: "The line is a tangent"."""
        return self.almost.replace("almost ", "")

    def said(self, gap: float | Decimal) -> str:
        """What a decision with that gap came to: "the line cuts the circle by 3.1e-7·e"."""
        below, exactly, above = self.sides
        if not gap:
            return exactly
        return f"{below} by {short(-gap)}·e" if gap < 0 else f"{above} by {short(gap)}·e"

    def sentence(self, gap: float) -> str:
        """What InvalidCase says of that part of e."""
        return f"{self.almost} (gap {short(abs(gap))}·e). {self.must}"


class Root(NamedTuple):
    """The number p + q·√d, d >= 0."""

    p: int
    q: int = 0
    d: int = 0


class Sure:
    """Decides the signs of lengths in a figure of this size e; all numbers are the figure's integers.

    Each method that decides raises InvalidCase where the length is neither 0 nor clear, and tells
    `judge.problem.declare.decisions` of it.
    """

    __slots__ = ("size",)

    def __init__(self, size: int) -> None:
        self.size = size

    def sign(
        self,
        p: int,
        q: int = 0,
        d: int = 0,
        u: int = 0,
        v: int = 0,
        *,
        per: int | Fraction = 1,
        share: int = CLEAR,
        zero: bool = True,
        what: DecisionWords,
    ) -> int:
        """The sign of x = p + q·√d + u·√v, where |x|/√per is the length: 0, or at least size/share.

        zero=False: 0 is invalid too.
        """
        found = two_root_sign(p, q, d, u, v)
        if found == 0:
            return self._exactly(zero, what)
        length = found * ((p << BITS) + _scaled_root(q, d) + _scaled_root(u, v)) - 2
        top, bottom = per.numerator, per.denominator
        size = isqrt(self.size * self.size * top * bottom << _UNIT) + 1  # size·√per, times the bottom

        def clear() -> bool:
            # x² = a + b·√d + (c + e·√d)·√v, times what makes it comparable with (size/share)²·per
            scale, least = share * share * bottom, self.size * self.size * top
            a, b = scale * (p * p + q * q * d + u * u * v) - least, scale * 2 * p * q
            c, e = scale * 2 * p * u, scale * 2 * q * u
            return _nested_sign(a, b, c, e, d, v) >= 0

        self._clear(found * max(length, 0) * bottom, size, share, what, clear)
        return found

    def distance(
        self, square: int, radius: int, per: int = 1, *, zero: bool = True, what: DecisionWords
    ) -> int:
        """The sign of the length √(square/per) − radius: 0, or clear; square, radius >= 0 and per > 0.

        With δ = square − radius²·per the length is δ/(√(square·per) + radius·per).
        """
        gap = square - radius * radius * per
        if gap == 0:
            return self._exactly(zero, what)
        reach = isqrt(square * per << _UNIT) + 1 + (radius * per << BITS)
        found = 1 if gap > 0 else -1

        def clear() -> bool:
            edge = radius * CLEAR + found * self.size  # where √(square/per) must be, or beyond it
            return edge >= 0 and found * (square * CLEAR * CLEAR - edge * edge * per) >= 0

        self._clear(gap << BITS, self.size * reach, CLEAR, what, clear)
        return found

    def nested(self, square: Root, radius: int, per: Root, *, zero: bool = True, what: DecisionWords) -> int:
        """`distance` for a square and a per in one root √d; two more roots certify its size."""
        whole = radius * radius
        p, q, d = square.p - whole * per.p, square.q - whole * per.q, square.d if square.q else per.d
        found = root_sign(p, q, d)
        if found == 0:
            return self._exactly(zero, what)
        gap = max(abs((p << BITS) + _scaled_root(q, d)) - 1, 0)
        above, below = ((x.p << BITS) + _scaled_root(x.q, x.d) + 1 for x in (square, per))
        reach = isqrt(above * below) + 1 + radius * below

        def clear() -> bool:
            edge, scale = radius * CLEAR + found * self.size, CLEAR * CLEAR
            p, q = square.p * scale - per.p * edge * edge, square.q * scale - per.q * edge * edge
            return edge >= 0 and found * root_sign(p, q, d) >= 0

        self._clear(found * gap, self.size * reach, CLEAR, what, clear)
        return found

    def least(self, square: int, share: int, what: str, *, zero: bool = True) -> None:
        """InvalidCase unless √square is at least size/share, or 0 where `zero` holds.

        `what` is the length's name, such as "The radius".
        """
        if square * share * share < self.size * self.size if square else not zero:
            part = short(isqrt(square << _UNIT) / ((self.size or 1) << BITS))
            wanted = f"{'0, or ' if zero else ''}at least {short(1 / share)}·e"
            refuse(f"{what} is {part}·e. It must be {wanted}.")

    def _exactly(self, zero: bool, what: DecisionWords) -> int:
        if not zero:
            raise InvalidCase(what.sentence(0.0))
        decided(what.name, 0.0)
        return 0

    def _clear(
        self, length: int, size: int, share: int, what: DecisionWords, clear: Callable[[], bool]
    ) -> None:
        """Record length/size, a lower bound, as a decision; InvalidCase where it is not `clear`."""
        gap = length / (size or 1)
        if not length or (abs(length) * share < size and not clear()):
            refuse(what.sentence(gap))
        decided(what.name, gap)


def _nested_sign(a: int, b: int, c: int, e: int, d: int, v: int) -> int:
    """The sign of (a + b·√d) + (c + e·√d)·√v, d and v >= 0, by one more squaring."""
    left, right = root_sign(a, b, d), root_sign(c, e, d) if v else 0
    if left * right >= 0:
        return left or right
    return left * root_sign(a * a + b * b * d - v * (c * c + e * e * d), 2 * (a * b - v * c * e), d)


def _scaled_root(q: int, d: int) -> int:
    """q·√d in units of 2**-BITS, rounded towards 0."""
    if not q or not d:
        return 0
    root = isqrt(q * q * d << _UNIT)
    return root if q > 0 else -root


def short(part: float | Decimal) -> str:
    """Two digits, such as 1.9e-11; 0.1 and more without a power of ten."""
    if part == 0 or part >= 0.1:
        return f"{part:.2g}"
    return f"{part:.1e}".replace(".0e", "e").replace("e-0", "e-")
