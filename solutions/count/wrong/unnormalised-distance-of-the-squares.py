"""unnormalised-distance

k² is compared with r² without the a that belongs to it. The line meets the circle where k² <= r²·a.
"""

from math import isclose


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    k2, r2 = (dx * fy - dy * fx) ** 2, r * r
    if isclose(k2, r2, rel_tol=1e-10):
        return 1
    return 2 if k2 < r2 else 0
