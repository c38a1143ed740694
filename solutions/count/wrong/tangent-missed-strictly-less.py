"""tangent-missed

d < r alone makes two points, and all else is a miss: a tangent gets 0, or 2 where it was rounded to the
inside. Ask for the tangency first, within a small part of the extent.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    return 2 if d < r else 0
