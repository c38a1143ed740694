"""fractions

A float is a fraction, so Δ = r²·|D|² − k² says without any rounding whether an edge's line cuts, touches or misses. Its
root is taken 400 bits below the point: where a corner is on the circle it is a fraction, and then this is exact, too.
"""

from fractions import Fraction
from math import isqrt


def root(x):
    return Fraction(isqrt((x.numerator << 800) // x.denominator), 1 << 400)


def boundary_hits(cx, cy, r, V):
    cx, cy, r = map(Fraction, (cx, cy, r))
    corners = [(Fraction(x) - cx, Fraction(y) - cy) for x, y in V]
    found = []
    for i, (fx, fy) in enumerate(corners):
        gx, gy = corners[(i + 1) % len(V)]
        dx, dy = gx - fx, gy - fy
        a, b, k = dx * dx + dy * dy, fx * dx + fy * dy, dx * fy - dy * fx
        delta = r * r * a - k * k
        if delta < 0:
            continue
        half = root(delta)
        for t in sorted({(-b - half) / a, (-b + half) / a}):
            if 0 <= t < 1:
                found.append((i, (float(cx + fx + t * dx), float(cy + fy + t * dy))))
    return found
