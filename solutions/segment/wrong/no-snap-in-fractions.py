"""no-snap

The roots are exact and so is 0 <= t <= 1: a common point 1e-17 beyond an end, by the rounding of the input, is lost.
Apply the statement's band at the ends too: up to 1e-12 of the extent beyond an end is on the segment.
"""

from fractions import Fraction as F
from math import isqrt


def circle_segment(cx, cy, r, A, B):
    cx, cy, r = F(cx), F(cy), F(r)
    ax, ay, bx, by = F(A[0]) - cx, F(A[1]) - cy, F(B[0]) - cx, F(B[1]) - cy
    near = F(1, 10**12) * max(r, abs(ax), abs(ay), abs(bx), abs(by))
    low, high = max(r - near, 0) ** 2, (r + near) ** 2
    dx, dy = bx - ax, by - ay
    a = dx * dx + dy * dy
    if a == 0:
        return [A] if low <= ax * ax + ay * ay <= high else []
    b = ax * dx + ay * dy
    k = dx * ay - dy * ax
    if k * k > high * a:
        return []
    if k * k >= low * a:
        ts = [-b / a]
    else:
        disc = r * r * a - k * k
        root = F(isqrt((disc.numerator << 600) // disc.denominator), 1 << 300)
        ts = [(-b - root) / a, (-b + root) / a]
    return [(float(cx + ax + t * dx), float(cy + ay + t * dy)) for t in ts if 0 <= t <= 1]
