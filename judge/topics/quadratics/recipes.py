"""Recipes for the coefficients (a, b, c) of a·t² + 2·b·t + c, each with one property.

All numbers are whole and below 2**53 before they are scaled by a power of two, so that a double holds each of
them. `numbers` is the type they arrive in: "int", "float", "mixed", or "any", a third of the cases each; a
scaled number that is not whole is a float. `size` bounds them, `bits` is how long they are, as (least, most).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import gcd, isqrt, ldexp

from judge.data.draw import Draw, require
from judge.problem.model import Number

Whole = tuple[int, int, int]
Coefficients = tuple[Number, Number, Number]
Bits = Sequence[int]

_MANTISSA = 53
_UNEVEN = 440  # binary orders: the root of b² − a·c is that of one of them, to the last digit
_ROOTS = 960  # of a root: it is to stay within the doubles
_FACTORS = 75_000_000, 94_900_000  # so that the product of two is about 2**53 and below it
_FINEST = 3_200_000_000_000_000  # the least b whose square is more than 1e31
_SIMILAR = 3  # roots of similar size: neither is more than so many times the other


def plain(draw: Draw, *, size: int, numbers: str = "any") -> Coefficients:
    """No roots, or two of similar size, so that no way of finding them loses digits."""
    a, b, c = (draw.integer(-size, size) for _ in range(3))
    delta = b * b - a * c
    if a == 0 or delta == 0 or (delta > 0 and _SIMILAR * abs(a * c) < (abs(b) + isqrt(delta) + 1) ** 2):
        draw.reject()
    return _typed(draw, (a, b, c), numbers, draw.choice((0, 0, -3)))


def cancellation(draw: Draw, *, bits: Bits, numbers: str = "any") -> Coefficients:
    """b² is far larger than |a·c|: −b and √Δ are nearly alike, by `bits` bits; a, b and c have any sign."""
    lost = draw.integer(*bits)
    long = draw.integer(max(6, lost // 2), min(_MANTISSA - 1, max(6, lost // 2) + 9))
    b = draw.integer(1 << long, (2 << long) - 1)
    product = max(1, (b * b) >> lost)
    a = draw.integer(1, max(1, min(product, 1 << draw.integer(1, 26))))
    c = max(1, product // a)
    if c >= 1 << _MANTISSA:
        draw.reject()
    whole = a * draw.sign(), b * draw.sign(), c * draw.sign()
    return _typed(draw, whole, numbers, draw.choice((0, 0, -7, 5)))


def b_zero(draw: Draw, *, size: int, numbers: str = "any") -> Coefficients:
    """b = 0: two roots of opposite signs, or none, or 0 alone; as a float, b is 0.0 or −0.0."""
    a = draw.integer(1, size) * draw.sign()
    kind = draw.choice(("two", "two", "square", "none", "zero"))
    c = {"zero": 0, "square": a * draw.integer(1, 9) ** 2}.get(kind, draw.integer(1, size) * (a // abs(a)))
    first, zero, last = _typed(draw, (a, 0, c if kind == "none" else -c), numbers, 0)
    return first, -zero if draw.boolean() else zero, last


def c_zero(draw: Draw, *, size: int, numbers: str = "any") -> Coefficients:
    """c = 0: one of the roots is 0."""
    a, b = (draw.integer(1, size) * draw.sign() for _ in range(2))
    return _typed(draw, (a, b, 0), numbers, draw.choice((0, -3)))


def linear(draw: Draw, *, size: int, numbers: str = "any") -> Coefficients:
    """a = 0: one root; with b = 0 as well none, and all of them 0 no equation."""
    kind = draw.choice(("root", "root", "zero", "none", "all"))
    b = draw.integer(1, size) * draw.sign() if kind in ("root", "zero") else 0
    c = draw.integer(1, size) * draw.sign() if kind in ("root", "none") else 0
    return _typed(draw, (0, b, c), numbers, draw.choice((0, -3)))


def zeros(draw: Draw, *, size: int, numbers: str = "any") -> Coefficients:
    """One of the three is not 0, or none is; as a float, 0 may be −0.0."""
    whole = [0, 0, 0]
    place = draw.choice((0, 0, 0, 1, 1, 1, 2, 3))
    if place < len(whole):
        whole[place] = draw.integer(1, size) * draw.sign()
    numbers_typed = _typed(draw, (whole[0], whole[1], whole[2]), numbers, draw.choice((0, -3)))
    a, b, c = (-each if each == 0 and draw.boolean() else each for each in numbers_typed)
    return a, b, c


def double(draw: Draw, *, size: int, numbers: str = "any") -> Coefficients:
    """Δ = 0: k·(p·t + q)²."""
    p, q, k = draw.integer(1, size), draw.integer(0, size) * draw.sign(), draw.integer(1, 9) * draw.sign()
    return _typed(draw, (k * p * p, k * p * q, k * q * q), numbers, draw.choice((0, -5)))


def near_double(
    draw: Draw, *, bits: Bits, numbers: str = "any", sides: Sequence[str] = ("two", "none")
) -> Coefficients:
    """Δ = ±j², small beside b²: the root of b·b − a·c in doubles is all rounding.

    With p·s − q·r = j, (p·r − q·s)² − (p² − q²)(r² − s²) = j² and (p·r + q·s)² − (p² + q²)(r² + s²) = −j².
    """
    reach = 1 << draw.integer(*bits)
    p, q = (draw.integer(reach // 2 + 1, reach) for _ in range(2))
    if gcd(p, q) != 1:
        draw.reject()
    s = pow(p, -1, q) if q > 1 else 1
    r = (p * s - 1) // q  # p·s − q·r = 1
    factor = draw.choice((1, 1, 1 << draw.integer(0, 9)))
    r, s = factor * r, factor * s
    require(p * s - q * r == factor, "p·s − q·r = j")
    if draw.choice(sides) == "none":
        a, b, c, delta = p * p + q * q, p * r + q * s, r * r + s * s, -factor * factor
    else:
        a, b, c, delta = p * p - q * q, p * r - q * s, r * r - s * s, factor * factor
    require(b * b - a * c == delta, "Δ = ±j²")
    if a == 0 or max(abs(a), abs(b), abs(c)) >= 1 << _MANTISSA:
        draw.reject()
    sign = draw.sign()
    b_sign = draw.sign()
    return _typed(draw, (sign * a, b_sign * b, sign * c), numbers, draw.choice((0, -20)))


def finest(draw: Draw, *, numbers: str = "any") -> Coefficients:
    """Δ = 1 beside a b² of more than 1e31, up to 2**106: two roots that differ in their last digits only.

    With z·w = x·y + 2, (x·y + 1)² − x·z·y·w = 1.
    """
    x, z = (draw.integer(*_FACTORS) for _ in range(2))
    if gcd(x, z) != 1:
        draw.reject()
    y = -2 * pow(x, -1, z) % z
    w = (x * y + 2) // z
    a, b, c = x * z, x * y + 1, y * w
    require(b * b - a * c == 1, "Δ = 1")
    if b < _FINEST or max(a, b, c) >= 1 << _MANTISSA:
        draw.reject()
    sign = draw.sign()
    return _typed(draw, (sign * a, draw.sign() * b, sign * c), numbers, draw.choice((0, -20)))


def wide(draw: Draw, *, exponents: Sequence[int], kinds: Sequence[str], numbers: str = "any") -> Coefficients:
    """Numbers whose squares leave the doubles: any of the `kinds` times 2**e, or a times it and c divided."""
    kind = draw.choice(kinds)
    require(kind in _WIDE, f"{kind!r} is a kind of equation")
    a, b, c = (_whole(each) for each in _WIDE[kind](draw))
    exponent = draw.choice(exponents)
    if draw.integer(0, 3):
        return _typed(draw, (a, b, c), numbers, exponent)
    return _scaled(a, exponent), b, _scaled(c, -exponent)  # the roots are divided by 2**e


def uneven(draw: Draw, *, exponents: Bits, size: int) -> Coefficients:
    """Each number times a power of two of its own: b² and a·c are hundreds of binary orders apart."""
    low, high = exponents
    ea, eb, ec = (draw.integer(low, high) for _ in range(3))
    apart = abs(2 * eb - ea - ec)
    if apart < _UNEVEN or max(abs(eb - ea), abs(ec - eb), abs(ec - ea) // 2) > _ROOTS:
        draw.reject()
    a, b, c = (draw.integer(1, size) * draw.sign() for _ in range(3))
    return ldexp(a, ea), ldexp(b, eb), ldexp(c, ec)


def _typed(draw: Draw, whole: Whole, numbers: str, exponent: int) -> Coefficients:
    """The numbers times 2**exponent, as ints where they are whole, as floats, or some of them as each."""
    require(numbers in ("any", "int", "float", "mixed"), f"{numbers!r} is a type of numbers")
    kind = ("int", "float", "mixed")[draw.integer(0, 2)] if numbers == "any" else numbers
    plain_int = [kind == "int" or (kind == "mixed" and draw.boolean()) for _ in whole]
    if kind == "mixed" and len(set(plain_int)) == 1:
        plain_int[draw.integer(0, 2)] ^= True
    if kind != "float":
        exponent = max(0, exponent) if exponent > -100 else exponent
    a, b, c = (
        _scaled(value, exponent) if as_int else float(_scaled(value, exponent))
        for value, as_int in zip(whole, plain_int, strict=True)
    )
    return a, b, c


def _scaled(value: int, exponent: int) -> Number:
    """The number times 2**exponent, exactly."""
    require(abs(value) < 1 << _MANTISSA, "a double holds the number")
    return value << exponent if exponent >= 0 else ldexp(value, exponent) if value else 0


def _whole(value: Number) -> int:
    require(value == int(value), f"{value!r} is whole")
    return int(value)


_WIDE: Mapping[str, Callable[[Draw], Coefficients]] = {
    "plain": lambda draw: plain(draw, size=99, numbers="int"),
    "cancellation": lambda draw: cancellation(draw, bits=(6, 50), numbers="int"),
    "b-zero": lambda draw: b_zero(draw, size=99, numbers="int"),
    "double": lambda draw: double(draw, size=99, numbers="int"),
    "near-double": lambda draw: near_double(draw, bits=(4, 17), numbers="int"),
    "linear": lambda draw: linear(draw, size=99, numbers="int"),
    "finest": lambda draw: finest(draw, numbers="int"),
    "long-double": lambda draw: near_double(draw, bits=(22, 25), numbers="int"),
}
BUILDERS: Mapping[str, Callable[..., Coefficients]] = {
    "plain": plain,
    "cancellation": cancellation,
    "b_zero": b_zero,
    "c_zero": c_zero,
    "linear": linear,
    "zeros": zeros,
    "double": double,
    "near_double": near_double,
    "finest": finest,
    "wide": wide,
    "uneven": uneven,
}
