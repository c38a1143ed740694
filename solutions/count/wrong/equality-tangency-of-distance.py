"""equality-tangency

The distance is compared with the radius by ==. After a division and a root it is hardly ever the same
double. Compare within a small fraction of the extent.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if d == r:
        return 1
    return 2 if d < r else 0
