"""whole-numbers

The input is cut down to whole numbers with int(). What is behind the point may be all there is of a figure:
leave the numbers as they are.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    cx, cy, r = int(cx), int(cy), int(r)
    A = int(A[0]), int(A[1])
    B = int(B[0]), int(B[1])
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
