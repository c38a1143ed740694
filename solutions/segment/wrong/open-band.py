"""open-band

Everything is exact, but what is off by exactly 1e-12 of the extent is left out: < stands where the statement says <=.
Let the band include its edge.
"""

from fractions import Fraction
from math import isqrt


def root(x):
    return Fraction(isqrt((x.numerator << 700) // x.denominator), 1 << 350)


def circle_segment(cx, cy, r, A, B):
    C = Fraction(cx), Fraction(cy)
    r = Fraction(r)
    (ax, ay), (bx, by) = [(Fraction(p[0]) - C[0], Fraction(p[1]) - C[1]) for p in (A, B)]
    e = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    band = e / 10**12
    dx, dy = bx - ax, by - ay
    a = dx * dx + dy * dy
    if a == 0:
        square = ax * ax + ay * ay
        on = e == 0 or max(r - band, 0) ** 2 < square < (r + band) ** 2 or square == r * r
        return [A] if on else []
    k2 = (dx * ay - dy * ax) ** 2
    b = ax * dx + ay * dy
    if k2 == r * r * a or max(r - band, 0) ** 2 * a < k2 < (r + band) ** 2 * a or r < band and k2 < (r + band) ** 2 * a:
        ts = [-b / a]
    elif k2 > r * r * a:
        return []
    else:
        w = root(r * r * a - k2)
        ts = [(-b - w) / a, (-b + w) / a]
    points = []
    for t in ts:
        beyond = max(-t, t - 1, 0)
        if beyond == 0 or beyond * beyond * a < band * band:
            points.append((float(C[0] + ax + t * dx), float(C[1] + ay + t * dy)))
    return points
