"""fractions

A float is a fraction, so Δ = r²·|D|² − k² says without any rounding whether the line cuts, touches or misses a circle.
Its root is taken 400 bits below the point: where a hit is at the origin it is a fraction, and then this is exact, too.
"""

from fractions import Fraction
from math import isqrt


def root(x):
    return Fraction(isqrt((x.numerator << 800) // x.denominator), 1 << 400)


def all_hits(circles, O, D):
    ox, oy, dx, dy = map(Fraction, (*O, *D))
    a = dx * dx + dy * dy
    hits = []
    for index, circle in enumerate(circles):
        x, y, r = map(Fraction, circle)
        fx, fy = ox - x, oy - y
        b, k = fx * dx + fy * dy, dx * fy - dy * fx
        delta = r * r * a - k * k
        if delta == 0:
            hits.append((-b / a, index, "touch"))
        elif delta > 0:
            half = root(delta)
            hits += [((-b - half) / a, index, "enter"), ((-b + half) / a, index, "exit")]
    return [(float(t), index, tag) for t, index, tag in sorted(hits) if t >= 0]
