"""sqrt-of-negative

The half-chord √(r² − d²) is taken before anybody has asked whether the line comes that close: every miss
ends in a ValueError. Compare the distance with the radius first.
"""

from math import hypot, sqrt


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(d - r) <= 1e-10 * e:
        return 1
    half = sqrt((r - d) * (r + d))
    return 2 if half > 0 else 0
