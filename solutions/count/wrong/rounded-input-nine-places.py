"""rounded-input

The numbers are rounded to nine decimal places first. What is beyond the ninth place may be all there is of
a small figure. A float is exactly the double it is: leave the input alone.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    cx, cy, r = round(cx, 9), round(cy, 9), round(r, 9)
    A = round(A[0], 9), round(A[1], 9)
    B = round(B[0], 9), round(B[1], 9)
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
