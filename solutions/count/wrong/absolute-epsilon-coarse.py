"""absolute-epsilon

The distance is compared with the radius within a fixed 1e-4. Figures smaller than that are all tangents.
Make the threshold a small part of the extent: 1e-10 of it.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if d > r + 1e-4:
        return 0
    return 1 if d > r - 1e-4 else 2
