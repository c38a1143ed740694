"""half-chord, in fractions

A float is a fraction, so the whole question is one of fractions: Δ = r²·|D|² − k² is 0 where the line touches,
and the chord is the root of 4·Δ/|D|². Only that root is rounded.
"""

from fractions import Fraction
from math import isqrt


def root(x):
    return float(Fraction(isqrt((x.numerator << 400) // x.denominator), 1 << 200))


def chord_length(cx, cy, r, A, B):
    cx, cy, r, ax, ay, bx, by = map(Fraction, (cx, cy, r, *A, *B))
    dx, dy = bx - ax, by - ay
    a = dx * dx + dy * dy
    if a == 0:
        return None
    k = dx * (ay - cy) - dy * (ax - cx)
    delta = r * r * a - k * k
    return None if delta < 0 else root(4 * delta / a)
