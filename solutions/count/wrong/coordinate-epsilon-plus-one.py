"""coordinate-epsilon

The threshold is a fraction of 1 plus all coordinates, "to be safe": for a small figure, or one far from the
origin, it is wider than the figure. Measure the extent from the centre, and add nothing to it.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = 1 + abs(cx) + abs(cy) + r + abs(A[0]) + abs(A[1]) + abs(B[0]) + abs(B[1])
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(d - r) <= 1e-12 * e:
        return 1
    return 2 if d < r else 0
