"""fractions

A float is a fraction, so each question is the sign of a fraction and needs no tolerance. Roots are taken 400 bits below
the point; a touch at the very end is asked for by the distance there, which is exact.
"""

from fractions import Fraction
from math import isqrt


def root(x):
    return Fraction(isqrt((x.numerator << 800) // x.denominator), 1 << 400)


def cross(u, v):
    return u[0] * v[1] - u[1] * v[0]


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1]


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def beside(p, a, b, r):
    """The sign of the distance from a segment less r; all of it is multiplied by the segment's length squared."""
    w, f = minus(b, a), minus(p, a)
    wall, foot = dot(w, w), dot(f, w)
    if 0 < foot < wall:
        gap = cross(w, f) ** 2 - r * r * wall
    else:
        f = minus(p, b) if foot > 0 else f
        gap = dot(f, f) - r * r
    return (gap > 0) - (gap < 0)


def time_of_impact(P0, P1, r, A, B):
    p, q, a, b = (tuple(map(Fraction, z)) for z in (P0, P1, A, B))
    r = Fraction(r)
    if beside(p, a, b, r) <= 0:
        return 0
    d, w = minus(q, p), minus(b, a)
    way, wall, turn = dot(d, d), dot(w, w), cross(w, d)
    if way == 0:
        return None
    times = []
    for end in (a, b):
        f = minus(p, end)
        delta = r * r * way - cross(d, f) ** 2
        if delta >= 0:
            times.append((-dot(f, d) - root(delta)) / way)
    if turn:
        f = minus(p, a)
        t = (r * root(wall) * (1 if cross(w, f) > 0 else -1) - cross(w, f)) / turn
        if 0 <= dot(f, w) + t * dot(d, w) <= wall:
            times.append(t)
    t = min((t for t in times if t > 0), default=2)
    if beside(q, a, b, r) == 0:
        t = min(t, 1)  # the roots are a hair off
    return float(t) if t <= 1 else None
