"""radius-epsilon

The threshold is a fraction of the radius. But the rounding errors grow with the distance of A and
B, which may be a million radii away, and a circle of radius 0 gets no threshold at all. Measure by
the extent of the whole case.
"""

from math import hypot, isclose


def line_count(cx, cy, r, A, B):
    if A[0] == B[0] and A[1] == B[1]:
        return None
    dx, dy = B[0] - A[0], B[1] - A[1]
    d = abs(dx * (A[1] - cy) - dy * (A[0] - cx)) / hypot(dx, dy)
    if isclose(d, r, rel_tol=1e-10):
        return 1
    return 2 if d < r else 0
