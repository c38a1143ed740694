"""equality-tangency

The direction is normalised first, and the cross product with the unit vector is compared with the radius by
==. Compare within a small fraction of the extent.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    ux, uy = dx / hypot(dx, dy), dy / hypot(dx, dy)
    d = abs(ux * fy - uy * fx)
    if d == r:
        return 1
    return 2 if d < r else 0
