"""rounded-root

|k| is compared with the whole part of √(r²·a): a line that misses by less than one of its units is a
tangent, and a hit is lost. Compare the squares: k² with r²·a.
"""

from math import isqrt


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = abs(dx * (A[1] - cy) - dy * (A[0] - cx))
    reach = isqrt(r * r * (dx * dx + dy * dy))
    if k == reach:
        return 1
    return 2 if k < reach else 0
