"""float-arithmetic

The cross product is exact, but it is compared with r·hypot(dx, dy), a float with 53 bits. Compare the
squares, in ints.
"""

from math import hypot


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = abs(dx * (A[1] - cy) - dy * (A[0] - cx))
    reach = r * hypot(dx, dy)
    if k == reach:
        return 1
    return 2 if k < reach else 0
