"""segment-for-line

Only points ahead of A are counted, as if the line began there. The question is about the infinite line:
drop the test of the parameter.
"""

from math import hypot, sqrt


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if d > r + 1e-10 * e:
        return 0
    foot = -(fx * dx + fy * dy) / hypot(dx, dy)
    half = sqrt((r - d) * (r + d)) if d < r - 1e-10 * e else 0.0
    return sum(s >= -1e-10 * e for s in {foot - half, foot + half})
