"""exact

Rational numbers throughout, the band of the statement as it stands; one root is taken to 60 digits.
"""

from fractions import Fraction
from math import isqrt

SNAP = Fraction(1, 10**12)


def square_root(value):
    """The root of a rational number from below, to about 60 digits."""
    shift = 400
    return Fraction(isqrt((value.numerator << 2 * shift) // value.denominator), 1 << shift)


def balls_meet(P0, P1, r, Q0, Q1, s):
    ax, ay, bx, by, cx, cy, gx, gy = map(Fraction, (*P0, *P1, *Q0, *Q1))
    reach = Fraction(r) + Fraction(s)
    dx, dy, fx, fy = (bx - ax) - (gx - cx), (by - ay) - (gy - cy), ax - cx, ay - cy
    slack = SNAP * max(reach, *map(abs, (bx - ax, by - ay, fx, fy, gx - ax, gy - ay)))
    if fx * fx + fy * fy <= (reach + slack) ** 2:
        return 0
    a, b, k = dx * dx + dy * dy, dx * fx + dy * fy, dx * fy - dy * fx
    if a == 0 or k * k > (reach + slack) ** 2 * a:
        return None
    if reach <= slack or k * k >= (reach - slack) ** 2 * a:
        t = -b / a
    else:
        t = (-b - square_root(reach * reach * a - k * k)) / a
    late = (t - 1) * max(abs(dx), abs(dy))
    return None if t < 0 or late > slack else float(t)
