"""fractions

A float is a fraction, so Δ = r²·|D|² − k² says without any rounding whether the ray's line cuts, touches or misses.
Its root is taken 400 bits below the point: where O is on the circle it is a fraction, and then this is exact, too.
"""

from fractions import Fraction
from math import isqrt


def root(x):
    return Fraction(isqrt((x.numerator << 800) // x.denominator), 1 << 400)


def reflect(cx, cy, r, O, D):
    cx, cy, r, ox, oy, dx, dy = map(Fraction, (cx, cy, r, *O, *D))
    fx, fy = ox - cx, oy - cy
    a, b, k = dx * dx + dy * dy, fx * dx + fy * dy, dx * fy - dy * fx
    delta = r * r * a - k * k
    if a == 0 or r == 0 or delta < 0:
        return None
    half = root(delta)
    for t in ((-b - half) / a, (-b + half) / a):
        if t >= 0:
            gx, gy = fx + t * dx, fy + t * dy
            twice = 2 * (dx * gx + dy * gy) / (r * r)
            return (float(ox + t * dx), float(oy + t * dy)), (float(dx - twice * gx), float(dy - twice * gy))
    return None
