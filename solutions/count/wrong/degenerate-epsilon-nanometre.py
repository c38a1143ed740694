"""degenerate-epsilon

Points closer than 1e-9 are taken for one. They are two exact points and make an exact line: only A == B has
none.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if abs(dx) < 1e-9 and abs(dy) < 1e-9:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
