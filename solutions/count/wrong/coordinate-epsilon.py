"""coordinate-epsilon

The threshold is a fraction of the largest coordinate. Far from the origin that says nothing about
the size of the figure: a small circle there gets a threshold as wide as itself. Measure coordinates
from the centre.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    d = abs(dx * (A[1] - cy) - dy * (A[0] - cx)) / hypot(dx, dy)
    scale = max(abs(v) for v in (cx, cy, r, *A, *B))
    if abs(d - r) <= 1e-10 * scale:
        return 1
    return 2 if d < r else 0
