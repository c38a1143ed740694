"""equality-tangency

Everything is exact, so a tangent whose numbers were rounded to doubles is a hit or a miss by 1e-17.
Apply the statement's band, which says what the truth is: |d - r| <= 1e-12 of the extent is a tangency.
"""

from fractions import Fraction as F
from math import isqrt


def circle_segment(cx, cy, r, A, B):
    cx, cy, r = F(cx), F(cy), F(r)
    ax, ay, bx, by = F(A[0]) - cx, F(A[1]) - cy, F(B[0]) - cx, F(B[1]) - cy
    near = F(1, 10**12) * max(r, abs(ax), abs(ay), abs(bx), abs(by))
    dx, dy = bx - ax, by - ay
    a = dx * dx + dy * dy
    if a == 0:
        square = ax * ax + ay * ay
        return [A] if max(r - near, 0) ** 2 <= square <= (r + near) ** 2 else []
    b = ax * dx + ay * dy
    k = dx * ay - dy * ax
    disc = r * r * a - k * k
    if disc < 0:
        return []
    root = F(isqrt((disc.numerator << 600) // disc.denominator), 1 << 300)
    ts = sorted({(-b - root) / a, (-b + root) / a})
    kept = [t for t in ts if max(-t, t - 1, 0) ** 2 * a <= near * near]
    return [(float(cx + ax + t * dx), float(cy + ay + t * dy)) for t in kept]
