"""fractions

A float is a fraction, so Δ = (r + s)²·|D|² − k² says without any rounding whether the ways cross, graze or miss. Its
root is taken 400 bits below the point: where the discs touch at an end it is a fraction, and then this is exact, too.
"""

from fractions import Fraction
from math import isqrt


def root(x):
    return Fraction(isqrt((x.numerator << 800) // x.denominator), 1 << 400)


def balls_meet(P0, P1, r, Q0, Q1, s):
    ax, ay, bx, by, cx, cy, gx, gy = map(Fraction, (*P0, *P1, *Q0, *Q1))
    reach = Fraction(r) + Fraction(s)
    dx, dy, fx, fy = (bx - ax) - (gx - cx), (by - ay) - (gy - cy), ax - cx, ay - cy
    if fx * fx + fy * fy <= reach * reach:
        return 0
    a, b, k = dx * dx + dy * dy, dx * fx + dy * fy, dx * fy - dy * fx
    delta = reach * reach * a - k * k
    if a == 0 or delta < 0:
        return None
    t = (-b - root(delta)) / a
    return float(t) if 0 <= t <= 1 else None
