"""segment-for-line

If the foot of the perpendicular is not between A and B, the line is said to miss. The question is about the
infinite line: the foot may be anywhere on it.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    t = -(fx * dx + fy * dy) / (dx * dx + dy * dy)
    if not 0 <= t <= 1:
        return 0
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
