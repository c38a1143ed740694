"""cancellation

The doubled area of the triangle A, B, C is the root of |a|²·|b|² − (a·b)², two numbers that are nearly
equal when C is near the line. The cross product gives it without a difference of large squares.
"""

from math import sqrt


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    p, q = float(fx) ** 2 + float(fy) ** 2, float(B[0] - cx) ** 2 + float(B[1] - cy) ** 2
    dot = float(fx) * (B[0] - cx) + float(fy) * (B[1] - cy)
    d = sqrt(max(0.0, p * q - dot * dot) / (dx * dx + dy * dy))
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
