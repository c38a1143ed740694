"""whole-numbers

The distance is computed with //, which drops everything behind the point: lines that pass within
one unit of the circle become tangents. Use /, or compare k² with r²·a and divide by nothing.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    d = abs(dx * (A[1] - cy) - dy * (A[0] - cx)) // hypot(dx, dy)
    if d == r:
        return 1
    return 2 if d < r else 0
