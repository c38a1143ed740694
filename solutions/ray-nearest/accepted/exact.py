"""exact

Rational numbers throughout; the one square root is taken to 120 digits by the integer root.
"""

from fractions import Fraction
from math import isqrt

SNAP = Fraction(1, 10**12)


def ray_nearest(cx, cy, r, O, D):
    r = Fraction(r)
    fx, fy = Fraction(O[0]) - Fraction(cx), Fraction(O[1]) - Fraction(cy)
    dx, dy = map(Fraction, D)
    a = dx * dx + dy * dy
    if a == 0:
        return None
    slack = SNAP * max(r, abs(fx), abs(fy))
    b = fx * dx + fy * dy
    k = dx * fy - dy * fx

    inner, outer = max(r - slack, 0), r + slack
    if k * k > outer * outer * a:
        return None
    if k * k >= inner * inner * a:
        roots = [-b / a]
    else:
        value = r * r * a - k * k
        root = Fraction(isqrt((value.numerator << 800) // value.denominator), 1 << 400)
        roots = [(-b - root) / a, (-b + root) / a]

    for t in roots:
        if t * t * a <= slack * slack:
            return 0
        if t > 0:
            return float(t)
    return None
