"""absolute-epsilon

|k| and r·|D|, two areas, are compared within a fixed 1e-9. Compare lengths, and with a small part of the
extent.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    k, reach = abs(dx * fy - dy * fx), r * hypot(dx, dy)
    if abs(k - reach) < 1e-9:
        return 1
    return 2 if k < reach else 0
