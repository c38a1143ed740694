"""zero-radius

A radius of 0 is refused as "no circle". The statement allows it: the circle is then its centre, and
a line through that point has one point in common with it.
"""

import math


def line_count(cx, cy, r, A, B):
    x1, y1, x2, y2 = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    if (x1, y1) == (x2, y2) and tuple(A) == tuple(B):
        return None
    if r <= 0:
        return 0
    distance = abs((B[0] - A[0]) * y1 - (B[1] - A[1]) * x1) / math.hypot(B[0] - A[0], B[1] - A[1])
    slack = 1e-10 * max(r, abs(x1), abs(y1), abs(x2), abs(y2))
    if distance < r - slack:
        return 2
    if distance <= r + slack:
        return 1
    return 0
