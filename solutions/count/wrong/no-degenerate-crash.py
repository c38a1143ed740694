"""no-degenerate

The direction is divided by its length before anybody has asked whether it has one: for A == B that
is a division by zero. There is no line then; return None before anything else.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    px, py = A[0] - cx, A[1] - cy
    qx, qy = B[0] - cx, B[1] - cy
    length = hypot(B[0] - A[0], B[1] - A[1])
    nx, ny = (A[1] - B[1]) / length, (B[0] - A[0]) / length
    d = abs(nx * px + ny * py)
    if abs(d - r) <= 1e-10 * max(r, abs(px), abs(py), abs(qx), abs(qy)):
        return 1
    return 0 if d > r else 2
