"""loose-epsilon

The threshold is 3e-7 of the extent, a little wider than the promise: some lines that clearly cross or miss
the circle become tangents. Choose it between the band of the tangents and the promised gap: 1e-10.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(d - r) <= 3e-7 * e:
        return 1
    return 2 if d < r else 0
