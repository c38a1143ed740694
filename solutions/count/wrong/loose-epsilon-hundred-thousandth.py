"""loose-epsilon

The threshold is 1e-5 of the extent, a hundred times the promised gap. Choose it between the band of the
tangents and that gap: 1e-10.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if d > r + 1e-5 * e:
        return 0
    if d < r - 1e-5 * e:
        return 2
    return 1
