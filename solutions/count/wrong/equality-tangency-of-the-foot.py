"""equality-tangency

The foot of the perpendicular is computed, and its distance from the centre compared with the radius by ==.
After so many roundings it is hardly ever the same double. Compare within a small fraction of the extent.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    t = -(fx * dx + fy * dy) / (dx * dx + dy * dy)
    d = hypot(fx + t * dx, fy + t * dy)
    if d > r:
        return 0
    return 1 if d == r else 2
