"""Scenes of a quadratic equation: each draws the (a, b, c) of a·t² + 2·b·t + c with one property.

All numbers are whole and below 2**53 before a power of two scales them, so that a double holds each of them.
Of the cases a third are ints where they are whole, a third floats, a third both.
"""

from __future__ import annotations

from math import gcd, isqrt, ldexp

from judge.data.draw import Draw
from judge.geometry.level import Scene, maker

Number = int | float
Coefficients = tuple[Number, Number, Number]

_MANTISSA = 53
_LONGEST = 600  # bits of a number before the point
_UNEVEN = 440  # binary orders: the root of b² − a·c is that of one of them, to the last digit
_ROOTS = 960  # of a root: it is to stay within the doubles
_FACTORS = 75_000_000, 94_900_000  # so that the product of two is about 2**53 and below it
_FINEST = 3_200_000_000_000_000  # the least b whose square is more than 1e31
_SIMILAR = 3  # roots of similar size: neither is more than so many times the other


@maker
def plain(draw: Draw, size: int) -> Coefficients:
    """No roots, or two of similar size, so that no way of finding them loses digits."""
    a, b, c = (draw.integer(-size, size) for _ in range(3))
    delta = b * b - a * c
    if a == 0 or delta == 0 or (delta > 0 and _SIMILAR * abs(a * c) < (abs(b) + isqrt(delta) + 1) ** 2):
        draw.reject()
    return _typed(draw, (a, b, c), draw.choice((0, 0, -3)))


@maker
def cancellation(draw: Draw, least: int, most: int) -> Coefficients:
    """b² is 2**least to 2**most times larger than |a·c|: −b and √Δ are nearly alike."""
    lost = draw.integer(least, most)
    long = draw.integer(max(6, lost // 2), min(_MANTISSA - 1, max(6, lost // 2) + 9))
    b = draw.integer(1 << long, (2 << long) - 1)
    product = max(1, (b * b) >> lost)
    a = draw.integer(1, max(1, min(product, 1 << draw.integer(1, 26))))
    c = max(1, product // a)
    if c >= 1 << _MANTISSA:
        draw.reject()
    return _typed(draw, (a * draw.sign(), b * draw.sign(), c * draw.sign()), draw.choice((0, 0, -7, 5)))


@maker
def b_zero(draw: Draw, size: int) -> Coefficients:
    """b = 0: two roots of opposite signs, or none, or 0 alone; as a float, b is 0.0 or −0.0."""
    a = draw.integer(1, size) * draw.sign()
    kind = draw.choice(("two", "two", "square", "none", "zero"))
    c = {"zero": 0, "square": a * draw.integer(1, 9) ** 2}.get(kind, draw.integer(1, size) * (a // abs(a)))
    first, zero, last = _typed(draw, (a, 0, c if kind == "none" else -c), 0)
    return first, -zero if draw.boolean() else zero, last


@maker
def b_small(draw: Draw) -> Coefficients:
    """b is 2**-2 to 2**-52 of √|a·c|, and not 0: it still counts in the last digits of both roots."""
    bits = draw.integer(1, _MANTISSA)
    a, b, c = (draw.integer(1 << bits - 1, (1 << bits) - 1) * draw.sign() for _ in range(3))
    shift, apart = draw.integer(-260, 260), draw.integer(-260, 260)
    return ldexp(a, shift + apart), ldexp(b, shift - draw.integer(2, 52)), ldexp(c, shift - apart)


@maker
def full(draw: Draw) -> Coefficients:
    """Three numbers of 53 bits and of similar size: digits are lost, but few."""
    least = draw.choice((52, 44))  # all of one binade, or not
    a, b, c = (
        ldexp(draw.integer(1 << 52, (1 << 53) - 1) * draw.sign(), -draw.integer(least, 52)) for _ in range(3)
    )
    return a, b, c


@maker
def c_zero(draw: Draw, size: int) -> Coefficients:
    """c = 0: one of the roots is 0."""
    a, b = (draw.integer(1, size) * draw.sign() for _ in range(2))
    return _typed(draw, (a, b, 0), draw.choice((0, -3)))


@maker
def linear(draw: Draw, size: int) -> Coefficients:
    """a = 0: one root; with b = 0 as well none, and all of them 0 no equation."""
    kind = draw.choice(("root", "root", "zero", "none", "all"))
    b = draw.integer(1, size) * draw.sign() if kind in ("root", "zero") else 0
    c = draw.integer(1, size) * draw.sign() if kind in ("root", "none") else 0
    return _typed(draw, (0, b, c), draw.choice((0, -3)))


@maker
def zeros(draw: Draw, size: int) -> Coefficients:
    """One of the three is not 0, or none is; as a float, 0 may be −0.0."""
    whole = [0, 0, 0]
    place = draw.choice((0, 0, 0, 1, 1, 1, 2, 3))
    if place < len(whole):
        whole[place] = draw.integer(1, size) * draw.sign()
    typed = _typed(draw, (whole[0], whole[1], whole[2]), draw.choice((0, -3)))
    a, b, c = (-each if each == 0 and draw.boolean() else each for each in typed)
    return a, b, c


@maker
def double(draw: Draw, size: int) -> Coefficients:
    """Δ = 0: k·(p·t + q)²."""
    p, q, k = draw.integer(1, size), draw.integer(0, size) * draw.sign(), draw.integer(1, 9) * draw.sign()
    return _typed(draw, (k * p * p, k * p * q, k * q * q), draw.choice((0, -5)))


@maker
def near_double(draw: Draw, least: int, most: int) -> Coefficients:
    """Δ = ±j², small beside b², which has about 2**least to 2**most of twice the bits.

    With p·s − q·r = j, (p·r − q·s)² − (p² − q²)(r² − s²) = j² and (p·r + q·s)² − (p² + q²)(r² + s²) = −j².
    """
    reach = 1 << draw.integer(least, most)
    p, q = (draw.integer(reach // 2 + 1, reach) for _ in range(2))
    if gcd(p, q) != 1:
        draw.reject()
    s = pow(p, -1, q) if q > 1 else 1
    j = draw.choice((1, 1, 1 << draw.integer(0, 9)))
    r, s = j * ((p * s - 1) // q), j * s
    if draw.boolean():
        a, b, c = p * p + q * q, p * r + q * s, r * r + s * s
    else:
        a, b, c = p * p - q * q, p * r - q * s, r * r - s * s
    if a == 0 or max(abs(a), abs(b), abs(c)) >= 1 << _MANTISSA:
        draw.reject()
    sign = draw.sign()
    return _typed(draw, (sign * a, draw.sign() * b, sign * c), draw.choice((0, -20)))


@maker
def finest(draw: Draw) -> Coefficients:
    """Δ = 1 beside a b² of 1e31 and more: two roots that differ in their last digits only.

    With z·w = x·y + 2, (x·y + 1)² − x·z·y·w = 1.
    """
    x, z = (draw.integer(*_FACTORS) for _ in range(2))
    if gcd(x, z) != 1:
        draw.reject()
    y = -2 * pow(x, -1, z) % z
    a, b, c = x * z, x * y + 1, y * ((x * y + 2) // z)
    if b < _FINEST or max(a, b, c) >= 1 << _MANTISSA:
        draw.reject()
    sign = draw.sign()
    return _typed(draw, (sign * a, draw.sign() * b, sign * c), draw.choice((0, -20)))


@maker
def wide(draw: Draw, exponents: tuple[int, ...], *scenes: Scene) -> Coefficients:
    """Equations in whole numbers times 2**e, or a times it and c divided by it."""
    found = draw.choice(scenes)(draw)
    if any(x != int(x) for x in found):
        draw.reject()
    a, b, c = map(int, found)
    exponent = draw.choice(exponents)
    if max(a, b, c, -a, -b, -c).bit_length() + abs(exponent) > _LONGEST:
        draw.reject()
    if draw.integer(0, 3):
        return _typed(draw, (a, b, c), exponent)
    return _scaled(a, exponent), b, _scaled(c, -exponent)  # the roots are divided by 2**e


@maker
def uneven(draw: Draw, low: int, high: int, size: int) -> Coefficients:
    """Each number times a power of two of its own: b² and a·c are hundreds of binary orders apart."""
    ea, eb, ec = (draw.integer(low, high) for _ in range(3))
    apart = abs(2 * eb - ea - ec)
    if apart < _UNEVEN or max(abs(eb - ea), abs(ec - eb), abs(ec - ea) // 2) > _ROOTS:
        draw.reject()
    a, b, c = (draw.integer(1, size) * draw.sign() for _ in range(3))
    return ldexp(a, ea), ldexp(b, eb), ldexp(c, ec)


def _typed(draw: Draw, whole: tuple[int, int, int], exponent: int) -> Coefficients:
    """The numbers times 2**exponent, as ints where they are whole, as floats, or some of them as each."""
    kind = ("int", "float", "mixed")[draw.integer(0, 2)]
    as_int = [kind == "int" or (kind == "mixed" and draw.boolean()) for _ in whole]
    if kind == "mixed" and len(set(as_int)) == 1:
        as_int[draw.integer(0, 2)] ^= True
    if kind != "float":
        exponent = max(0, exponent) if exponent > -100 else exponent
    a, b, c = (
        _scaled(value, exponent) if each else float(_scaled(value, exponent))
        for value, each in zip(whole, as_int, strict=True)
    )
    return a, b, c


def _scaled(value: int, exponent: int) -> Number:
    """The number times 2**exponent, exactly."""
    return value << exponent if exponent >= 0 else ldexp(value, exponent) if value else 0
