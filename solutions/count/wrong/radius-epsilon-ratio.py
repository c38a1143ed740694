"""radius-epsilon

d/r is compared with 1. That makes the radius the measure of rounding errors that grow with the distance of
A and B, and a circle of radius 0 divides by zero. Measure by the extent of the whole case.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    ratio = d / r
    if abs(ratio - 1) < 1e-10:
        return 1
    return 2 if ratio < 1 else 0
