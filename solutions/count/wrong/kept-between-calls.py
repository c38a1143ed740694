"""kept-between-calls

The size lives in a global that is never reset: after one large case the threshold stays large,
and the next small circle is swallowed by it. Start every call afresh, with local names.
"""

from math import hypot

size = 0


def grow(*lengths):
    global size
    for length in lengths:
        size = max(size, abs(length))


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    grow(r, A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy)
    d = abs(dx * (A[1] - cy) - dy * (A[0] - cx)) / hypot(dx, dy)
    if abs(d - r) <= 1e-10 * size:
        return 1
    return 2 if d < r else 0
