"""equality-tangency

Everything is exact, so a tangent whose numbers were rounded to doubles is a hit or a miss by 1e-17.
Apply the statement's band, which says what the truth is: |d - r| <= 1e-12 of the extent is a tangency.
"""

from fractions import Fraction as F
from math import isqrt


def ray_nearest(cx, cy, r, O, D):
    r = F(r)
    fx, fy, dx, dy = F(O[0]) - F(cx), F(O[1]) - F(cy), F(D[0]), F(D[1])
    a = dx * dx + dy * dy
    if a == 0:
        return None
    b = fx * dx + fy * dy
    disc = r * r * a - (dx * fy - dy * fx) ** 2
    if disc < 0:
        return None
    root = F(isqrt((disc.numerator << 800) // disc.denominator), 1 << 400)
    near = F(1, 10**12) * max(r, abs(fx), abs(fy))
    for t in ((-b - root) / a, (-b + root) / a):
        if t * t * a <= near * near:
            return 0
        if t > 0:
            return float(t)
    return None
