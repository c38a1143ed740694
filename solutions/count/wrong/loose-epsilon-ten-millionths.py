"""loose-epsilon

The threshold is 1e-6 of the size, wider than what the statement promises to be clear: some lines that cut or miss the
circle become tangents. Compare within 1e-9 of the size.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(d - r) <= 1e-6 * e:
        return 1
    return 2 if d < r else 0
