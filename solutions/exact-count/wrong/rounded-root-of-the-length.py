"""rounded-root

|D| is rounded down to a whole number with isqrt, and r·|D| with it. Compare the squares: k² with r²·a.
"""

from math import isqrt


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = abs(dx * (A[1] - cy) - dy * (A[0] - cx))
    reach = r * isqrt(dx * dx + dy * dy)
    if k == reach:
        return 1
    return 2 if k < reach else 0
