"""degenerate-epsilon

A line is taken for a point when A and B are closer than 1e-10 of the extent. Seen from far away they may
be, and still make an exact line: only A == B has none.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    length = hypot(dx, dy)
    if length <= 1e-10 * e:
        return None
    d = abs(dx * fy - dy * fx) / length
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
