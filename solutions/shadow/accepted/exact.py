"""exact

Rational numbers, and roots to 80 digits: the point that is hit is known so well that nothing can go wrong.
"""

from fractions import Fraction
from math import isqrt


def square_root(value):
    """The root of a rational number from below."""
    shift = 600
    return Fraction(isqrt((value.numerator << 2 * shift) // value.denominator), 1 << shift)


def roots(circle, start, way):
    x, y, r = circle
    fx, fy = start[0] - x, start[1] - y
    a, b = way[0] ** 2 + way[1] ** 2, fx * way[0] + fy * way[1]
    delta = r * r * a - (way[0] * fy - way[1] * fx) ** 2
    if delta < 0:
        return ()
    root = square_root(delta)
    return (-b - root) / a, (-b + root) / a


def light(circles, O, D, L):
    scene = [tuple(map(Fraction, circle)) for circle in circles]
    start, way, lamp = (tuple(map(Fraction, pair)) for pair in (O, D, L))
    hits = [(t, index) for index, circle in enumerate(scene) for t in roots(circle, start, way) if t > 0]
    if not hits:
        return None
    t, own = min(hits)
    p = start[0] + t * way[0], start[1] + t * way[1]
    n = p[0] - scene[own][0], p[1] - scene[own][1]
    v = lamp[0] - p[0], lamp[1] - p[1]
    if (way[0] * n[0] + way[1] * n[1] < 0) != (v[0] * n[0] + v[1] * n[1] > 0):
        return "dark"
    least = Fraction(1, 10**30)
    return "dark" if any(least < s < 1 for circle in scene for s in roots(circle, p, v)) else "lit"
