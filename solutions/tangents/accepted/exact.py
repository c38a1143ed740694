"""exact

Rational numbers throughout; the one square root is taken to 60 digits by the integer root.
"""

from fractions import Fraction
from math import isqrt

def square_root(value):
    """The root of a rational number from below, to about 60 digits."""
    shift = 400
    return Fraction(isqrt((value.numerator << 2 * shift) // value.denominator), 1 << shift)


def tangent_points(cx, cy, r, P):
    cx, cy, r = Fraction(cx), Fraction(cy), Fraction(r)
    fx, fy = Fraction(P[0]) - cx, Fraction(P[1]) - cy
    if not r:
        return [(float(cx), float(cy))]
    square = fx * fx + fy * fy
    if square > r * r:
        a, b = r * r / square, r * square_root(square - r * r) / square
        ends = [(cx + a * fx + s * b * fy, cy + a * fy - s * b * fx) for s in (1, -1)]
        return [(float(x), float(y)) for x, y in ends]
    return [tuple(P)] if square == r * r else []
