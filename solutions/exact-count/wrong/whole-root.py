"""whole-root

The points are wanted as whole numbers, or not at all: a discriminant that is no perfect square counts as a
miss. The points need not be on the grid; only the sign of the discriminant matters.
"""

from math import isqrt


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    a = dx * dx + dy * dy
    if not a:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    delta = r * r * a - k * k
    if delta < 0:
        return 0
    root = isqrt(delta)
    if root * root != delta:
        return 0
    return 2 if root else 1
