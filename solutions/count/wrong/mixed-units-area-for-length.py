"""mixed-units

The cross product and r·|D| are areas, but the threshold they are compared with is a length, 1e-10 of the
extent. Divide by |D| first, or multiply the threshold by it.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    k = abs(dx * fy - dy * fx)
    reach = r * hypot(dx, dy)
    if abs(k - reach) <= 1e-10 * e:
        return 1
    return 2 if k < reach else 0
