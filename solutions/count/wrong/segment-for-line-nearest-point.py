"""segment-for-line

The distance is that of the nearest point between A and B, whose parameter is clamped to 0 and 1. The
question is about the infinite line: do not clamp.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    t = -(fx * dx + fy * dy) / (dx * dx + dy * dy)
    t = max(0, min(1, t))
    d = hypot(fx + t * dx, fy + t * dy)
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
