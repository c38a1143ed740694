"""exact

Rational numbers throughout, the band of the statement as it stands; roots are taken to 60 digits.
"""

from fractions import Fraction
from math import isqrt

SNAP = Fraction(1, 10**12)


def square_root(value):
    """The root of a rational number from below, to about 60 digits."""
    shift = 400
    return Fraction(isqrt((value.numerator << 2 * shift) // value.denominator), 1 << shift)


def cross(u, v):
    return u[0] * v[1] - u[1] * v[0]


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1]


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def squared_distance(p, a, b):
    """That of a point from a segment."""
    w, f = minus(b, a), minus(p, a)
    share = min(max(dot(f, w) / dot(w, w), Fraction(0)), Fraction(1)) if any(w) else 0
    off = f[0] - share * w[0], f[1] - share * w[1]
    return dot(off, off)


def time_of_impact(P0, P1, r, A, B):
    p, q, a, b = (tuple(map(Fraction, z)) for z in (P0, P1, A, B))
    r = Fraction(r)
    slack = SNAP * max(r, *(abs(x) for end in (a, b) for place in (p, q) for x in minus(end, place)))
    if squared_distance(p, a, b) <= (r + slack) ** 2:
        return 0
    d, w = minus(q, p), minus(b, a)
    if not any(d):
        return None
    times = []
    square = dot(d, d)
    for end in (a, b):
        f = minus(p, end)
        k = cross(d, f) ** 2
        if k <= (r - slack) ** 2 * square:
            times.append((-dot(f, d) - square_root(r * r * square - k)) / square)
        elif k <= (r + slack) ** 2 * square:
            times.append(-dot(f, d) / square)
    turn, height, wall = cross(w, d), cross(w, minus(p, a)), dot(w, w)
    if turn:
        side = r * square_root(wall) * (1 if height > 0 else -1)
        t = (side - height) / turn
        if 0 <= dot(minus(p, a), w) + t * dot(d, w) <= wall:
            times.append(t)
    t = min(times, default=-1)
    late = (t - 1) * max(abs(d[0]), abs(d[1]))
    return None if t < 0 or late > slack else float(t)
