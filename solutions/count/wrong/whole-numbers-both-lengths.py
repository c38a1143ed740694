"""whole-numbers

The distance and the radius are both cut down to whole numbers before they are compared. Compare them as
they are.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    d, r = int(abs(dx * fy - dy * fx) / hypot(dx, dy)), int(r)
    if d == r:
        return 1
    return 2 if d < r else 0
