"""single-precision

The input is stored in 32-bit floats, with 24 bits each, and all after that is done in doubles; but the
digits are gone by then. Use doubles from the start.
"""

from array import array
from math import hypot


def line_count(cx, cy, r, A, B):
    cx, cy, r, *points = array("f", [cx, cy, r, *A, *B])
    A, B = points[:2], points[2:]
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(d - r) <= 1e-6 * e:
        return 1
    return 2 if d < r else 0
