"""swapped-coordinates

The product of B - A and A - C is taken with x and y mixed up, which gives the position along the
line and not the distance from it. The cross product is dx·fy - dy·fx; the dot product is dx·fx +
dy·fy.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if not dx and not dy:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    d = abs(dx * fx - dy * fy) / hypot(dx, dy)
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
