"""quadratic, in fractions

A float is a fraction, so the quadratic in t is one of fractions: a·t² + 2·b·t + c = 0, and b² − a·c says without any
rounding how many roots it has. Its root is taken 400 bits below the point: where O is on the sphere it is a fraction,
and then this is exact, too.
"""

from fractions import Fraction
from math import isqrt


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def root(x):
    return Fraction(isqrt((x.numerator << 800) // x.denominator), 1 << 400)


def ray_sphere(C, r, O, D):
    r, d = Fraction(r), [Fraction(x) for x in D]
    f = [Fraction(o) - Fraction(c) for o, c in zip(O, C)]
    a, b = dot(d, d), dot(f, d)
    delta = b * b - a * (dot(f, f) - r * r)
    if a == 0 or r == 0 or delta < 0:
        return None
    half = root(delta)
    for t, side in (((-b - half) / a, 1), ((-b + half) / a, -1)):
        if t >= 0:
            return float(t), [float(side * (x + t * y) / r) for x, y in zip(f, d)]
    return None
