"""cancellation

The height of the triangle A, B, C comes from its sides by Heron's formula, which subtracts nearly equal
lengths when A and B are far away. Take the area from the cross product of the coordinates.
"""

from math import hypot, sqrt


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    p, q, s = hypot(fx, fy), hypot(B[0] - cx, B[1] - cy), hypot(dx, dy)
    half = (p + q + s) / 2
    d = 2 * sqrt(max(0.0, half * (half - p) * (half - q) * (half - s))) / s
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
