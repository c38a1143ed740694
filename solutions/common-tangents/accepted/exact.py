"""fractions

A float is a fraction, so d² against (r1 − r2)² and (r1 + r2)² says without any rounding which tangents there are, and
which two are one. With q = r1 − r2 for an outer one and r1 + r2 for an inner one, only √(d² − q²) is rounded.
"""

from fractions import Fraction
from math import isqrt


def root(x):
    return Fraction(isqrt((x.numerator << 800) // x.denominator), 1 << 400)


def common_tangents(cx1, cy1, r1, cx2, cy2, r2):
    x, y, p, r = Fraction(cx1), Fraction(cy1), Fraction(r1), Fraction(r2)
    vx, vy = Fraction(cx2) - x, Fraction(cy2) - y
    square = vx * vx + vy * vy
    found = []
    for q in (p - r, p + r):
        over = square - q * q
        heights = (root(over), -root(over)) if over > 0 else (0,) if over == 0 else ()
        found += [(float(x + p * (q * vx - h * vy) / square), float(y + p * (q * vy + h * vx) / square)) for h in heights]
    return found
