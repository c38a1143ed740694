"""absolute-epsilon

The distance and the radius are compared with a fixed 1e-6, "to be on the safe side". Small circles
are swallowed by it whole. Make the epsilon a small part of the extent: 1e-10 of it.
"""

from math import hypot

EPS = 1e-6


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    gap = abs(dx * (A[1] - cy) - dy * (A[0] - cx)) / hypot(dx, dy) - r
    if gap > EPS:
        return 0
    return 2 if gap < -EPS else 1
