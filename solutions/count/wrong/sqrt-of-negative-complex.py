"""sqrt-of-negative

The root is taken with ** 0.5, which of a negative number is a complex one, and two different complex
numbers count as two points. Decide on the sign of the discriminant first.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    half = 0 if abs(d - r) <= 1e-10 * e else ((r - d) * (r + d)) ** 0.5
    return len({-half, half})
