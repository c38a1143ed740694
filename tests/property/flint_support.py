"""Numbers (p + q√d)/s at random, and what python-flint says of them."""

from __future__ import annotations

import math
import random
import sys
from fractions import Fraction

import flint

Parts = tuple[int, int, int, int]


def ball(parts: Parts, precision: int) -> flint.arb:
    """An enclosure of (p + q√d)/s from flint, at least that fine before cancellation."""
    flint.ctx.prec = precision
    p, q, d, s = parts
    return (flint.arb(p) + flint.arb(q) * flint.arb(d).sqrt()) / flint.arb(s)


def sign_of(value_at, zero) -> int:
    """The sign of what `value_at(precision)` encloses; `zero()` says whether it is 0."""
    for precision in (128, 512, 2048, 8192):
        value = value_at(precision)
        if value > 0:
            return 1
        if value < 0:
            return -1
    assert zero()
    return 0


def big(random_source: random.Random, bits: int) -> int:
    return random_source.getrandbits(random_source.randint(1, bits)) * random_source.choice((-1, 1))


def any_parts(source: random.Random) -> Parts:
    """Sizes from small to huge, with cancellation, perfect squares and subnormal quotients among them."""
    shape = source.randrange(6)
    bits = source.choice((4, 16, 64, 200))
    p, q, d, s = big(source, bits), big(source, bits), abs(big(source, bits)), abs(big(source, bits)) + 1
    if shape == 1:  # p² close to q²d: nearly all of it cancels
        p = -math.isqrt(q * q * d) * (1 if q > 0 else -1) + source.randint(-1, 1)
    elif shape == 2:  # around the subnormal doubles
        s <<= 1060 + source.randint(-30, 30) + p.bit_length() - s.bit_length()
    elif shape == 3:  # around the largest double
        p, q = p << 1015 - bits // 2, q << 1015 - bits // 2
    elif shape == 4:
        q = 0
    elif shape == 5:
        d = d * d
    return p, q, d, s


def bounds_as_fractions(value: flint.arb) -> tuple[Fraction, Fraction]:
    """Exact ends of a ball."""
    middle, radius = value.mid(), value.rad()
    ends = []
    for number in (middle - radius, middle + radius):
        mantissa, exponent = number.mid().man_exp()
        mantissa, exponent = int(mantissa), int(exponent)
        ends.append(Fraction(mantissa * 2**exponent) if exponent >= 0 else Fraction(mantissa, 2**-exponent))
    slack = (ends[1] - ends[0]) / 2**20  # the ends were rounded themselves
    return ends[0] - slack, ends[1] + slack


def fraction_to_nearest(value: Fraction) -> float:
    try:
        return value.numerator / value.denominator
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def rounded_down(value: Fraction) -> float:
    near = fraction_to_nearest(value)
    if math.isinf(near):
        return sys.float_info.max if near > 0 else near
    return near if Fraction(near) <= value else math.nextafter(near, -math.inf)


def rounded_up(value: Fraction) -> float:
    return -rounded_down(-value)


def oracle(parts: Parts) -> tuple[float, float, float]:
    """(down, nearest, up) from flint's enclosures, refined until both ends round alike."""
    p, q, d, s = parts
    root = math.isqrt(d)
    if q == 0 or root * root == d:
        exact = Fraction(p + q * root, s)
        return rounded_down(exact), fraction_to_nearest(exact), rounded_up(exact)
    for precision in (160, 640, 2560, 10240):
        low, high = bounds_as_fractions(ball(parts, precision))
        results = [(rounded_down(end), fraction_to_nearest(end), rounded_up(end)) for end in (low, high)]
        if results[0] == results[1]:
            return results[0]
    raise AssertionError(f"flint could not separate {parts}")


def decimal_exponent(value: Fraction) -> int:
    """floor(log10(value)) of a positive rational."""
    exponent = len(str(value.numerator)) - len(str(value.denominator))
    return exponent if value >= Fraction(10) ** exponent else exponent - 1
