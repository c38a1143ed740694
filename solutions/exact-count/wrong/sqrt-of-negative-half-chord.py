"""sqrt-of-negative

The root of r²·a − k² is taken before its sign is known: a line that misses the circle ends in a ValueError.
Only the sign is needed, and no root at all.
"""

from math import isqrt


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    reach = r * r * (dx * dx + dy * dy)
    half = isqrt(reach - k * k)
    if half * half == reach - k * k == 0:
        return 1
    return 2
