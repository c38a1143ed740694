"""fractions

A float is a fraction, so Δ = r²·|D|² − k² says without any rounding whether the line cuts, touches or misses. Its root
is taken 400 bits below the point: where an end is on the circle it is a fraction, and then this is exact, too.
"""

from fractions import Fraction
from math import isqrt


def root(x):
    return Fraction(isqrt((x.numerator << 800) // x.denominator), 1 << 400)


def circle_segment(cx, cy, r, A, B):
    cx, cy, r, ax, ay, bx, by = map(Fraction, (cx, cy, r, *A, *B))
    fx, fy, dx, dy = ax - cx, ay - cy, bx - ax, by - ay
    a, b, k = dx * dx + dy * dy, fx * dx + fy * dy, dx * fy - dy * fx
    if a == 0:
        return [tuple(A)] if fx * fx + fy * fy == r * r else []
    delta = r * r * a - k * k
    if delta < 0:
        return []
    half = root(delta)
    times = [(-b - half) / a, (-b + half) / a] if delta else [-b / a]
    return [(float(ax + t * dx), float(ay + t * dy)) for t in times if 0 <= t <= 1]
