"""float-arithmetic

The distance is a float and is compared within 1e-9: that hides the rounding of a tangent, and every near
miss as well. Compare r²·a with k² in ints.
"""

from math import sqrt


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = abs(dx * (A[1] - cy) - dy * (A[0] - cx))
    d = k / sqrt(dx * dx + dy * dy)
    if abs(d - r) < 1e-9:
        return 1
    return 2 if d < r else 0
