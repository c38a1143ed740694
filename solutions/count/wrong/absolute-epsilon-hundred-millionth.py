"""absolute-epsilon

The distance is compared with the radius within 1e-8, whatever the size of the figure. Make the threshold a
small part of the extent: 1e-10 of it.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(d - r) <= 1e-8:
        return 1
    return 2 if d < r else 0
