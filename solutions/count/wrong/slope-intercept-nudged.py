"""slope-intercept

A vertical line gets a slope by moving one of its points a little to the side, and is no longer the line
that was asked about. Work with the direction B − A and the cross product.
"""

from math import sqrt


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    m = dy / (dx if dx != 0 else 1e-6)
    n = fy - m * fx
    d = abs(n) / sqrt(1 + m * m)
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
