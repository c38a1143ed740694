"""rounded-root

The distance is rounded down to a whole number before it is compared, so that a miss by less than
one is a tangent. Compare the squares: k² with r²·a.
"""

from math import isqrt


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    distance = isqrt(k * k // (dx * dx + dy * dy))
    return 2 if distance < r else 1 if distance == r else 0
