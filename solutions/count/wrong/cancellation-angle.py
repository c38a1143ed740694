"""cancellation

The distance is |f|·sin of the angle at A, and the sine comes from the cosine by √(1 − cos²): when the angle
is small nearly nothing is left of it. The cross product gives |f|·sin at once.
"""

from math import hypot, sqrt


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    away = hypot(fx, fy)
    cosine = (dx * fx + dy * fy) / (hypot(dx, dy) * away) if away else 1.0
    d = away * sqrt(max(0.0, 1 - cosine * cosine))
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
