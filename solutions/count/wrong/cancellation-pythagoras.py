"""cancellation

The distance comes from the triangle A, C and the foot, as |f|² - (f·D)²/a: two numbers that are
nearly equal when A is far away. The cross product gives the same distance without a difference of
large squares: |D × f| / |D|.
"""

from math import sqrt


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    fx, fy = A[0] - cx, A[1] - cy
    a = dx * dx + dy * dy
    if a == 0:
        return None
    along = (fx * dx + fy * dy) / sqrt(a)
    d = sqrt(abs(fx * fx + fy * fy - along * along))
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
