"""quadratic, in fractions

A float is a fraction, so the quadratic in t is one of fractions: a·t² + 2·b·t + c = 0, and b² − a·c says without any
rounding how many roots it has. Only the square root is rounded, 200 bits below the point.
"""

from fractions import Fraction
from math import isqrt


def root(x):
    return Fraction(isqrt((x.numerator << 400) // x.denominator), 1 << 200)


def line_points(cx, cy, r, A, B):
    cx, cy, r, ax, ay, bx, by = map(Fraction, (cx, cy, r, *A, *B))
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    a, b, c = dx * dx + dy * dy, dx * fx + dy * fy, fx * fx + fy * fy - r * r
    if a == 0:
        return None
    under = (b * b - a * c) / (a * a)
    if under < 0:
        return []
    half = root(under)
    times = [-b / a - half, -b / a + half] if under else [-b / a]
    return [(float(ax + t * dx), float(ay + t * dy)) for t in times]
