"""rounded-input

The numbers are rounded to twelve decimal places "to get rid of noise". In a figure of 1e-9 that is most of
them. A float is exactly the double it is: leave the input alone.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    cx, cy, r, ax, ay, bx, by = (round(v, 12) for v in (cx, cy, r, *A, *B))
    A, B = (ax, ay), (bx, by)
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
