"""Recipes for doubles whose roundings in k = dx·fy − dy·fx work together, near the worst for a bound of Δ.

With u = 2**-53 and M = |dx·fy| + |dy·fx|, the double of Δ = r²·a − k² may be off by 6·u·M·|k| where M is far
larger than |k|, and by 9·u²·M² where k itself is rounded away. The sign of Δ is another one than the
double's, or 0.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import inf, isqrt, nextafter

from judge.data.draw import Draw
from judge.topics.circles.figures.figure import Figure, Recipe, draw_mirrored, line, scaled

Exponents = int | Sequence[int]

_U = 2.0**-53
_ONE = 1 << 52  # integers that are doubles of 1 to 2 stand for so many of their units
_FINE = 1 << 240  # squares are taken to half of these digits
_TRIES, _STRIDE, _PACE = 400, 0x9E3779B97F, 648_887  # of walks through numbers without a pattern


def cancelling(draw: Draw, *, bits: Sequence[int], exponent: Exponents = 0) -> Figure:
    """A tangent but for next to nothing, |k| being about 2**-bits of M: all roundings of k go one way."""
    up, narrow = draw.boolean(), 52 - draw.choice(bits)
    (x, y), (z, w) = (_rounded_product(draw, way, narrow) for way in (up, not up))
    if x * y <= z * w:
        draw.reject()
    return _crossed(draw, (x, y, z, w), 1 if up else -1, exponent)


def vanishing(draw: Draw, *, exponent: Exponents = 0) -> Figure:
    """dx·fy and dy·fx are one double, and k is 0 there; it is nearly 3·u·M, and |D|·r just below it."""
    step = 1 << draw.integer(22, 26)
    beyond = round(0.98 * _ONE / step) - step
    number = draw.integer(1, 1 << 30)
    for at in range(number, number + _TRIES * _PACE, _PACE):
        x, y = at + beyond, at
        if 0.485 < x * y % _ONE / _ONE < 0.5:
            numbers = (_ONE + x, _ONE + y, _ONE + x + step, _ONE + y - step)
            return _crossed(draw, numbers, -1, exponent)
    return draw.reject()


def _crossed(draw: Draw, numbers: tuple[int, int, int, int], sign: int, exponent: Exponents) -> Figure:
    """D and f of doubles (dx, fy, dy, fx) above 1, rounded so that k is too great (1) or too small (-1)."""
    dx, fy, dy, fx = (number / _ONE for number in numbers)
    off = sign * draw.integer(9900, 9999) / 10000 * _U
    wide, high = Fraction(dx) - Fraction(off), Fraction(dy) + Fraction(off)
    k = wide * (Fraction(fy) - Fraction(off)) - high * (Fraction(fx) + Fraction(off))
    square = wide * wide + high * high
    r = float(Fraction(isqrt(int(k * k / square * _FINE)), isqrt(_FINE)))
    while (Fraction(r) ** 2 * square < k * k) if sign > 0 else (Fraction(r) ** 2 * square > k * k):
        r = nextafter(r, sign * inf)
    power = draw.choice(exponent) if isinstance(exponent, Sequence) else exponent
    # A stays A: f is taken from there.
    return scaled(draw_mirrored(draw, line((-fx, -fy), r, (off, -off), (dx, dy))), power)


def _rounded_product(draw: Draw, up: bool, narrow: int) -> tuple[int, int]:
    """Two numbers, in units of 2**-52, up to 2**narrow above 1, whose product loses nearly half a unit."""
    first, number = _ONE + draw.integer(1, 1 << narrow), draw.integer(1, 1 << narrow)
    for at in range(number, number + _TRIES * _STRIDE, _STRIDE):
        second = _ONE + at % (1 << narrow)
        low = first * second % _ONE - (1 << 51)  # beyond the half, where it is rounded up
        if 0 < (low if up else -low) < 1 << 47:
            return first, second
    return draw.reject()


RECIPES: Mapping[str, Recipe] = {"cancelling": cancelling, "vanishing": vanishing}
