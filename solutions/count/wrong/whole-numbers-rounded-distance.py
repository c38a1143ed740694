"""whole-numbers

The distance is rounded to a whole number before it is compared with the radius: lines that pass within half
a unit of the circle become tangents. Compare it as it is.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    d = round(abs(dx * fy - dy * fx) / hypot(dx, dy))
    if d == r:
        return 1
    return 2 if d < r else 0
