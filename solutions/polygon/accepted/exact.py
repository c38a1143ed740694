"""exact

Rational numbers throughout; the one square root is taken to 120 digits by the integer root.
"""

from fractions import Fraction
from math import isqrt

SNAP = Fraction(1, 10**12)


def root(value):
    return Fraction(isqrt((value.numerator << 800) // value.denominator), 1 << 400)


def boundary_hits(cx, cy, r, V):
    r, cx, cy = Fraction(r), Fraction(cx), Fraction(cy)
    corners = [(Fraction(x), Fraction(y)) for x, y in V]
    slack = SNAP * max(r, *(max(abs(x - cx), abs(y - cy)) for x, y in corners))
    found = []
    for i, (ax, ay) in enumerate(corners):
        bx, by = corners[(i + 1) % len(V)]
        dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
        a, b, k = dx * dx + dy * dy, fx * dx + fy * dy, dx * fy - dy * fx
        if k * k > (r + slack) ** 2 * a:
            continue
        inner = max(r - slack, 0)
        if k * k >= inner * inner * a:
            ts = [-b / a]
        else:
            half = root(r * r * a - k * k)
            ts = [(-b - half) / a, (-b + half) / a]
        for t in ts:
            starts, ends = t * t * a <= slack * slack, (t - 1) ** 2 * a <= slack * slack
            if starts or (0 < t < 1 and not ends):
                found.append((i, (float(ax + t * dx), float(ay + t * dy))))
    return found
