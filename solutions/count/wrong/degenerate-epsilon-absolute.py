"""degenerate-epsilon

A line shorter than 1e-15 is taken for a point. On a small figure that is a length like any other:
only A == B has no line.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    length = hypot(dx, dy)
    if length < 1e-15:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    d = abs(dx * fy - dy * fx) / length
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
