"""length-epsilon

The threshold is a fraction of |B - A| and of the radius. Two points that are far away but close
together give a threshold that is too narrow for their rounding. The distances of A and B from the
centre belong to the extent.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    length = hypot(dx, dy)
    if length == 0:
        return None
    d = abs((A[0] - cx) * dy - (A[1] - cy) * dx) / length
    if abs(d - r) <= 1e-10 * max(length, r):
        return 1
    return 2 if d < r else 0
