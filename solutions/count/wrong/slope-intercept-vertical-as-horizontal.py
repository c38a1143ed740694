"""slope-intercept

Where the slope would be a division by zero it is set to 0, so that a vertical line is treated as a
horizontal one. Work with the direction B − A and the cross product.
"""

from math import sqrt


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    m = dy / dx if dx else 0.0
    d = abs(fy - m * fx) / sqrt(1 + m * m)
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
