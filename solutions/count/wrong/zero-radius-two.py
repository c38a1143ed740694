"""zero-radius

A circle of radius 0 has no tangents here: a line through its centre gets 2. It is a single point: one point
in common.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if d > r + 1e-10 * e:
        return 0
    return 1 if r > 0 and d >= r - 1e-10 * e else 2
