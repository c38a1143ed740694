"""float-arithmetic

The foot of the perpendicular is computed in floats, and its distance from the centre compared with the
radius by ==. A double has 53 bits: compare r²·a with k² in ints.
"""

from math import hypot


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    t = -(fx * dx + fy * dy) / (dx * dx + dy * dy)
    d = hypot(fx + t * dx, fy + t * dy)
    if d == r:
        return 1
    return 2 if d < r else 0
