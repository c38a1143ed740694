"""rounded-input

The coordinates seen from the centre are rounded to seven decimal places. What is beyond the seventh place
may be what decides. Leave them alone.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    fx, fy, gx, gy, r = (round(v, 7) for v in (fx, fy, B[0] - cx, B[1] - cy, r))
    dx, dy = gx - fx, gy - fy
    e = max(r, abs(fx), abs(fy), abs(gx), abs(gy))
    d = abs(dx * fy - dy * fx) / (hypot(dx, dy) or 1)
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
