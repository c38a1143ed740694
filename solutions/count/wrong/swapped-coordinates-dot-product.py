"""swapped-coordinates

The dot product of B − A and A − C is divided by the length, which gives how far along the line the foot is
and not how far away the line. The cross product is dx·fy − dy·fx.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fx + dy * fy) / hypot(dx, dy)
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
