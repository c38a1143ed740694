"""open-band

Everything is exact, but what is off by exactly 1e-12 of the extent is left out: < stands where the statement says <=.
Let the band include its edge.
"""

from fractions import Fraction as F
from math import isqrt


def ray_nearest(cx, cy, r, O, D):
    r = F(r)
    fx, fy, dx, dy = F(O[0]) - F(cx), F(O[1]) - F(cy), F(D[0]), F(D[1])
    a = dx * dx + dy * dy
    if not a:
        return None
    band = max(r, abs(fx), abs(fy)) / 10**12
    b, k2, r2a = fx * dx + fy * dy, (dx * fy - dy * fx) ** 2, r * r * a
    touching = k2 == r2a or k2 < (r + band) ** 2 * a and (r < band or k2 > (r - band) ** 2 * a)
    if not touching and k2 > r2a:
        return None
    w = 0
    if not touching:
        q = r2a - k2
        w = F(isqrt((q.numerator << 800) // q.denominator), 1 << 400)
    for t in ((-b - w) / a, (-b + w) / a):
        if t == 0 or t * t * a < band * band:
            return 0
        if t > 0:
            return float(t)
    return None
