"""zero-radius

A circle of radius 0 is taken for a degenerate input and answered with None, like A == B. It is a
circle that consists of its centre: the line has one point in common with it, or none.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if r == 0 or (dx == 0 and dy == 0):
        return None
    fx, fy = A[0] - cx, A[1] - cy
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    slack = 1e-10 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    if d < r - slack:
        return 2
    return 1 if d <= r + slack else 0
