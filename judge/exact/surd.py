"""Real numbers (p + q·√d)/s over Python's integers: sign, order, rounding and text, all of it exact.

Python's own numbers are taken as the rationals that they are: every finite double is an integer over a power
of two.
"""

from __future__ import annotations

from decimal import MAX_EMAX, MIN_EMIN, ROUND_HALF_EVEN, Context, Decimal, Inexact
from fractions import Fraction
from math import inf, isinf, isnan, isqrt, nextafter
from typing import Any

from judge.exact.signs import root_sign, two_root_sign

Rational = int | float | Fraction | Decimal

_LEAST_EXPONENT = -1074  # of the least subnormal, and of every double's last bit at least
_BITS = 56  # enough for a double and what tells on which side of it or of a tie a number is


class Surd:
    """The number (p + q·√d)/s, never changed; s > 0, d >= 0, and irrational exactly where q != 0.

    A radicand that is a perfect square is folded into p. Compares with any other Surd, int, float, Fraction
    and Decimal by value, and hashes like them. `float()` rounds correctly, ties to even.
    Raises ValueError for a negative radicand, ZeroDivisionError for s == 0, TypeError for anything but ints.
    """

    __slots__ = ("d", "p", "q", "s")

    def __init__(self, p: int, q: int = 0, d: int = 0, s: int = 1) -> None:
        for part in (p, q, d, s):
            if type(part) is not int:
                raise TypeError(f"a Surd is made of ints, not of {type(part).__name__}")
        if d < 0:
            raise ValueError("the radicand is negative")
        if s == 0:
            raise ZeroDivisionError("a Surd with denominator 0")
        if s < 0:
            p, q, s = -p, -q, -s
        if q and (root := isqrt(d)) ** 2 == d:
            p, q = p + q * root, 0
        self.p, self.q, self.d, self.s = p, q, d if q else 0, s

    @classmethod
    def of(cls, value: Rational | Surd) -> Surd:
        """`value` exactly; ValueError for nan and infinities, TypeError for a bool or any other type."""
        if isinstance(value, Surd):
            return value
        top, bottom = ratio(value)
        return make(top, 0, 0, bottom)

    def __repr__(self) -> str:
        return f"Surd({self.p}, {self.q}, {self.d}, {self.s})"

    def __str__(self) -> str:
        return self.decimal(17)

    def sign(self) -> int:
        """-1, 0 or +1."""
        return root_sign(self.p, self.q, self.d)

    # -- arithmetic with rationals ------------------------------------------------------------------

    def __neg__(self) -> Surd:
        return make(-self.p, -self.q, self.d, self.s)

    def __abs__(self) -> Surd:
        return -self if self.sign() < 0 else self

    def __add__(self, other: int | Fraction) -> Surd:
        if not isinstance(other, int | Fraction):
            return NotImplemented
        n, m = other.as_integer_ratio()
        return make(self.p * m + n * self.s, self.q * m, self.d, self.s * m)

    __radd__ = __add__

    def __sub__(self, other: int | Fraction) -> Surd:
        return self + -other if isinstance(other, int | Fraction) else NotImplemented

    def __rsub__(self, other: int | Fraction) -> Surd:
        return -self + other

    def __mul__(self, other: int | Fraction) -> Surd:
        if not isinstance(other, int | Fraction):
            return NotImplemented
        n, m = other.as_integer_ratio()
        return make(self.p * n, self.q * n, self.d, self.s * m)

    __rmul__ = __mul__

    def __truediv__(self, other: int | Fraction) -> Surd:
        return self * (1 / Fraction(other)) if isinstance(other, int | Fraction) else NotImplemented

    # -- order ---------------------------------------------------------------------------------------

    def compare(self, other: Surd | Rational) -> int:
        """-1, 0 or +1 as self is less than, equal to or greater than `other`, which may be infinite.

        Raises ValueError for nan, TypeError for what is no number.
        """
        if isinstance(other, Surd):
            mine, its = self.s, other.s
            p = self.p * its - other.p * mine
            return two_root_sign(p, self.q * its, self.d, -other.q * mine, other.d)
        if isinstance(other, float | Decimal) and isinf(other):
            return -1 if other > 0 else 1
        n, m = ratio(other)
        return root_sign(self.p * m - n * self.s, self.q * m, self.d)

    def _is(self, other: Any, *wanted: int) -> bool:
        if isinstance(other, float | Decimal) and isnan(other):
            return False
        known = isinstance(other, (Surd, int, float, Fraction, Decimal)) and not isinstance(other, bool)
        return self.compare(other) in wanted if known else NotImplemented

    def __eq__(self, other: object) -> bool:
        return self._is(other, 0)

    def __lt__(self, other: Surd | Rational) -> bool:
        return self._is(other, -1)

    def __le__(self, other: Surd | Rational) -> bool:
        return self._is(other, -1, 0)

    def __gt__(self, other: Surd | Rational) -> bool:
        return self._is(other, 1)

    def __ge__(self, other: Surd | Rational) -> bool:
        return self._is(other, 0, 1)

    def __bool__(self) -> bool:
        return self.q != 0 or self.p != 0

    def __hash__(self) -> int:
        # Equal irrationals may have different radicands (√8 = 2√2), but they round to the same double.
        return hash(float(self)) if self.q else hash(Fraction(self.p, self.s))

    # -- rounding ------------------------------------------------------------------------------------

    def _near(self, bits: int) -> tuple[int, int]:
        """A numerator and a denominator > 0: the number itself where it is rational.

        Else both lie between the same two neighbouring multiples of a power of two, and are at least
        2**(bits - 1) of it: so their first bits are the same, and they round alike.
        """
        p, q, s = self.p, self.q, self.s
        if q == 0:
            return p, s
        square = q * q * self.d
        # |x| = |p² − q²d| / (s·|p − q√d|) tells how small it is where p and q√d cancel each other.
        reach = max(p.bit_length(), (square.bit_length() + 1) // 2)
        k = max(0, bits + 1 + reach + s.bit_length() - (p * p - square).bit_length())
        root = isqrt(square << 2 * k)  # never exact, so that floor(−√…) is −root − 1
        return 2 * (((p << k) + (root if q > 0 else -root - 1)) // s) + 1, 2 << k

    def __float__(self) -> float:
        top, bottom = self._near(_BITS)
        try:
            return top / bottom  # int / int is correctly rounded
        except OverflowError:
            return inf if top > 0 else -inf

    def round_down(self) -> float:
        """The greatest double <= self; a number that is a double stays itself, -inf below the least."""
        near = float(self)
        return near if self.compare(near) >= 0 else nextafter(near, -inf)

    def round_up(self) -> float:
        """The least double >= self; a number that is a double stays itself, inf above the largest."""
        near = float(self)
        return near if self.compare(near) <= 0 else nextafter(near, inf)

    def ulp_exponent(self) -> int:
        """The exponent of the last bit of a double of its size: floor(log2|x|) − 52, at least −1074."""
        top, bottom = self._near(2)
        if not top:
            return _LEAST_EXPONENT
        top = abs(top)
        size = top.bit_length() - bottom.bit_length()
        size -= top << max(-size, 0) < bottom << max(size, 0)
        return max(size - 52, _LEAST_EXPONENT)

    def decimal(self, digits: int) -> str:
        """The number in decimal, rounded (ties to even) to `digits` >= 1 significant digits.

        Laid out like a float's repr. Numbers that need fewer digits print whole ("0.5", "3"); trailing zeros
        of the others are kept, since they are known.
        """
        context = Context(digits, ROUND_HALF_EVEN, MIN_EMIN, MAX_EMAX, traps=[])
        found = context.divide(*map(Decimal, self._near(digits * 10 // 3 + 80)))
        if not self.q and not context.flags[Inexact]:
            found = found.normalize(context)
        if -5 < found.adjusted() < 16:
            return f"{found:f}"
        digits_, _, exponent = f"{found:e}".partition("e")
        return f"{digits_}e{int(exponent):+03d}"


def make(p: int, q: int, d: int, s: int) -> Surd:
    """A Surd of parts known to be normal: s > 0, and √d irrational unless q == 0. Nothing is checked."""
    surd = object.__new__(Surd)
    surd.p, surd.q, surd.d, surd.s = p, q, d if q else 0, s
    return surd


def ratio(value: object) -> tuple[int, int]:
    """`value` (int, float, Fraction or Decimal) as numerator and denominator > 0.

    Raises ValueError for nan and infinities, TypeError for a bool or anything else.
    """
    if isinstance(value, bool) or not isinstance(value, Rational):
        raise TypeError(f"{type(value).__name__} is not a number that can be taken exactly")
    try:
        return value.as_integer_ratio()
    except (ValueError, OverflowError):
        raise ValueError(f"{value} is not a finite number") from None


def integers(*values: int | float) -> tuple[list[int], int]:
    """All `values` over one power of two: value i is result[i] / 2**shift, exactly, shift >= 0 least.

    Raises ValueError for nan and infinities, TypeError for a bool or anything but int and float.
    """
    kinds = {*map(type, values)}
    for kind in kinds - {int, float}:
        raise TypeError(f"{kind.__name__} is not an int or a float")
    if float not in kinds:
        return [*map(int, values)], 0
    ratios = [ratio(value) for value in values]
    bits = max([bottom for _, bottom in ratios]).bit_length()
    return [top << (bits - bottom.bit_length()) for top, bottom in ratios], bits - 1
