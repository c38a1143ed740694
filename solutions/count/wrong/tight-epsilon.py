"""tight-epsilon

The threshold is the machine epsilon times the extent: it leaves no room for more than one rounding,
nor for the band within which a line counts as a tangent. Use about 1e-10 of the extent.
"""

import sys
from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if not (dx or dy):
        return None
    fx, fy = A[0] - cx, A[1] - cy
    extent = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    gap = abs(dx * fy - dy * fx) / hypot(dx, dy) - r
    tiny = sys.float_info.epsilon * extent
    return 1 if abs(gap) <= tiny else 2 if gap < 0 else 0
