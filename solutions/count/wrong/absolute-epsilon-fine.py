"""absolute-epsilon

The distance is compared with the radius within 1e-10: the right figure, but of the extent, not of the unit.
Multiply it by the extent of the case.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(d - r) <= 1e-10:
        return 1
    return 2 if d < r else 0
