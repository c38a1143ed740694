"""slope-intercept

A vertical line, which has no slope, is answered with 0. Work with the direction B − A, which knows no
special direction.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0:
        return None if dy == 0 else 0
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
