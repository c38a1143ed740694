"""Real numbers (p + q·√d)/s over Python's integers: sign, order, rounding and text, all of it exact."""

from __future__ import annotations

from decimal import MAX_EMAX, MIN_EMIN, ROUND_HALF_EVEN, Context, Decimal, Inexact
from fractions import Fraction
from math import inf, isinf, isnan
from typing import Any, NoReturn, TypeGuard

from judge.exact import rounding
from judge.exact.dyadic import Rational, ratio
from judge.exact.signs import exact_root, root_sign, two_root_sign

_MOST_DIGITS = 4000  # Python itself refuses to print integers much longer
_BITS = 56  # enough for a double and a sticky bit


class Surd:
    """The number (p + q·√d)/s; immutable, s > 0, d >= 0, and irrational exactly where q != 0.

    A radicand that is a perfect square is folded into p. Compares with any other Surd, int, float, Fraction
    and Decimal by value, and hashes like them. `float()` rounds correctly, ties to even.
    Raises ValueError for a negative radicand, ZeroDivisionError for s == 0, TypeError for anything but ints.
    """

    __slots__ = ("d", "p", "q", "s")
    p: int
    q: int
    d: int
    s: int

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
        if q:
            root = exact_root(d)
            if root is not None:
                p, q = p + q * root, 0
        _set_p(self, p)
        _set_q(self, q)
        _set_d(self, d if q else 0)
        _set_s(self, s)

    @classmethod
    def of(cls, value: Rational | Surd) -> Surd:
        """`value` exactly; ValueError for nan and infinities, TypeError for a bool or any other type."""
        if isinstance(value, Surd):
            return value
        top, bottom = ratio(value)
        return make(top, 0, 0, bottom)

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise AttributeError("a Surd is immutable")

    def __delattr__(self, name: str) -> NoReturn:
        raise AttributeError("a Surd is immutable")

    def __reduce__(self) -> tuple[Any, ...]:
        return Surd, (self.p, self.q, self.d, self.s)

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
        if not _is_exact(other):
            return NotImplemented
        n, m = other.as_integer_ratio()
        return make(self.p * m + n * self.s, self.q * m, self.d, self.s * m)

    __radd__ = __add__

    def __sub__(self, other: int | Fraction) -> Surd:
        return self + -other if _is_exact(other) else NotImplemented

    def __rsub__(self, other: int | Fraction) -> Surd:
        return -self + other if _is_exact(other) else NotImplemented

    def __mul__(self, other: int | Fraction) -> Surd:
        if not _is_exact(other):
            return NotImplemented
        n, m = other.as_integer_ratio()
        return make(self.p * n, self.q * n, self.d, self.s * m)

    __rmul__ = __mul__

    def __truediv__(self, other: int | Fraction) -> Surd:
        if not _is_exact(other):
            return NotImplemented
        n, m = other.as_integer_ratio()
        if n == 0:
            raise ZeroDivisionError("a Surd divided by 0")
        if n < 0:
            n, m = -n, -m
        return make(self.p * m, self.q * m, self.d, self.s * n)

    # -- order ---------------------------------------------------------------------------------------

    def compare(self, other: Surd | Rational) -> int:
        """-1, 0 or +1 as self is less than, equal to or greater than `other`, which may be infinite.

        Raises ValueError for nan, TypeError for what is no number.
        """
        if isinstance(other, Surd):
            mine, its = self.s, other.s
            return two_root_sign(
                self.p * its - other.p * mine, self.q * its, self.d, -other.q * mine, other.d
            )
        if isinstance(other, (float, Decimal)) and isinf(other):
            return -1 if other > 0 else 1
        n, m = ratio(other)
        return root_sign(self.p * m - n * self.s, self.q * m, self.d)

    def __eq__(self, other: object) -> bool:
        return self.compare(other) == 0 if _is_comparable(other) else NotImplemented

    def __lt__(self, other: Surd | Rational) -> bool:
        return self._order(other, (-1,))

    def __le__(self, other: Surd | Rational) -> bool:
        return self._order(other, (-1, 0))

    def __gt__(self, other: Surd | Rational) -> bool:
        return self._order(other, (1,))

    def __ge__(self, other: Surd | Rational) -> bool:
        return self._order(other, (0, 1))

    def _order(self, other: Surd | Rational, wanted: tuple[int, ...]) -> bool:
        if isinstance(other, (float, Decimal)) and isnan(other):
            return False
        return self.compare(other) in wanted if _is_comparable(other) else NotImplemented

    def __bool__(self) -> bool:
        return self.q != 0 or self.p != 0

    def __hash__(self) -> int:
        # Equal irrationals may have different radicands (√8 = 2√2), but they round to the same double.
        return hash(float(self)) if self.q else hash(Fraction(self.p, self.s))

    # -- rounding ------------------------------------------------------------------------------------

    def __float__(self) -> float:
        if self.q == 0:
            try:
                return self.p / self.s  # int / int is correctly rounded
            except OverflowError:
                return inf if self.p > 0 else -inf
        side, m, k, exact = rounding.magnitude(self.p, self.q, self.d, self.s, _BITS)
        value = rounding.to_nearest(m, k, exact)
        return value if side > 0 else -value

    def round_down(self) -> float:
        """The greatest double <= self; a number that is a double stays itself, -inf below the least."""
        side, m, k, exact = rounding.magnitude(self.p, self.q, self.d, self.s, _BITS)
        return rounding.downward(m, k) if side >= 0 else -rounding.upward(m, k, exact)

    def round_up(self) -> float:
        """The least double >= self; a number that is a double stays itself, inf above the largest."""
        side, m, k, exact = rounding.magnitude(self.p, self.q, self.d, self.s, _BITS)
        return rounding.upward(m, k, exact) if side >= 0 else -rounding.downward(m, k)

    # -- ulps ----------------------------------------------------------------------------------------

    def ulp_exponent(self) -> int:
        """The exponent of `ulp()`: floor(log2|x|) − 52, at least −1074 (also for 0)."""
        side, m, k, _ = rounding.magnitude(self.p, self.q, self.d, self.s, 2)
        if side == 0:
            return rounding.LEAST_EXPONENT
        return max(m.bit_length() - 53 - k, rounding.LEAST_EXPONENT)

    def ulp(self) -> Fraction:
        """The unit in the last place of the exact number: 2**(floor(log2|x|) − 52), at least 2**−1074."""
        exponent = self.ulp_exponent()
        return Fraction(1 << exponent) if exponent >= 0 else Fraction(1, 1 << -exponent)

    # -- text ----------------------------------------------------------------------------------------

    def decimal(self, digits: int) -> str:
        """The number in decimal, correctly rounded (ties to even) to `digits` >= 1 significant digits.

        Laid out like a float's repr. Numbers that need fewer digits print whole ("0.5", "3"); trailing zeros
        of the others are kept, since they are known. Raises ValueError for digits outside 1 … 4000.
        """
        if not 1 <= digits <= _MOST_DIGITS:
            raise ValueError(f"between 1 and {_MOST_DIGITS} digits, not {digits}")
        if not self:
            return "0"
        top, bottom = abs(self.p), self.s
        if self.q:
            _, m, k, _ = rounding.magnitude(self.p, self.q, self.d, self.s, digits * 10 // 3 + 80)
            top, bottom = 2 * m + 1, 2 << k if k >= 0 else 1  # a sticky bit: what was cut off lies above m
            top <<= max(-k - 1, 0)
        context = Context(digits, ROUND_HALF_EVEN, MIN_EMIN, MAX_EMAX, traps=[])
        rounded = context.divide(Decimal(top), Decimal(bottom))
        text = "".join(map(str, rounded.as_tuple().digits))
        exact = not self.q and not context.flags[Inexact]
        return ("-" if self.sign() < 0 else "") + _layout(text, rounded.adjusted(), exact)


_set_p = Surd.__dict__["p"].__set__
_set_q = Surd.__dict__["q"].__set__
_set_d = Surd.__dict__["d"].__set__
_set_s = Surd.__dict__["s"].__set__
_blank = object.__new__


def make(p: int, q: int, d: int, s: int) -> Surd:
    """A Surd of parts known to be normal: s > 0, and √d irrational unless q == 0. Nothing is checked."""
    surd = _blank(Surd)
    _set_p(surd, p)
    _set_q(surd, q)
    _set_d(surd, d if q else 0)
    _set_s(surd, s)
    return surd


def _is_exact(value: object) -> bool:
    return isinstance(value, (int, Fraction)) and not isinstance(value, bool)


def _is_comparable(value: object) -> TypeGuard[Surd | Rational]:
    if isinstance(value, float):
        return not isnan(value)
    return isinstance(value, (Surd, int, Fraction, Decimal)) and not isinstance(value, bool)


def _layout(text: str, exponent: int, exact: bool) -> str:
    """Digits as a float's repr would set them: plain from 1e-4 to 1e16, else with an exponent."""
    if exact:
        text = text.rstrip("0") or "0"
    if -5 < exponent < 0:
        return "0." + "0" * (-exponent - 1) + text
    if 0 <= exponent < 16:
        whole, part = text[: exponent + 1].ljust(exponent + 1, "0"), text[exponent + 1 :]
        return f"{whole}.{part}" if part else whole
    part = f".{text[1:]}" if len(text) > 1 else ""
    return f"{text[0]}{part}e{'-' if exponent < 0 else '+'}{abs(exponent):02d}"
