"""exact

Rational numbers throughout; the one square root is taken to 120 digits by the integer root.
"""

from fractions import Fraction
from math import isqrt

SNAP = Fraction(1, 10**12)


def root(value):
    return Fraction(isqrt((value.numerator << 800) // value.denominator), 1 << 400)


def hit_normal(cx, cy, r, O, D):
    r = Fraction(r)
    dx, dy = map(Fraction, D)
    fx, fy = Fraction(O[0]) - Fraction(cx), Fraction(O[1]) - Fraction(cy)
    a = dx * dx + dy * dy
    if a == 0 or r == 0:
        return None
    slack = SNAP * max(r, abs(fx), abs(fy))
    b, k = fx * dx + fy * dy, dx * fy - dy * fx
    if k * k > (r + slack) ** 2 * a:
        return None
    if k * k >= (r - slack) ** 2 * a:
        hits = [(-b / a, 1)]
    else:
        half = root(r * r * a - k * k)
        hits = [((-b - half) / a, 1), ((-b + half) / a, -1)]
    for t, side in hits:
        if t >= 0 or t * t * a <= slack * slack:
            return float(side * (fx + t * dx) / r), float(side * (fy + t * dy) / r)
    return None
