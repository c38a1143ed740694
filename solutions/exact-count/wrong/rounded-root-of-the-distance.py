"""rounded-root

|k| // isqrt(a): both the length and the quotient are rounded down before the comparison. Compare the
squares: k² with r²·a.
"""

from math import isqrt


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = abs(dx * (A[1] - cy) - dy * (A[0] - cx))
    distance = k // isqrt(dx * dx + dy * dy)
    if distance == r:
        return 1
    return 2 if distance < r else 0
