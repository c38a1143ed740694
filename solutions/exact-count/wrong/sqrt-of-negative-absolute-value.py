"""sqrt-of-negative

The absolute value is taken under the root, "to be safe", and a miss gets two points as well. Only the sign
is needed, and no root at all.
"""

from math import isqrt


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    reach = r * r * (dx * dx + dy * dy)
    half = isqrt(4 * abs(reach - k * k))
    return 2 if half > 0 else 1
