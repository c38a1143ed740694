"""length-epsilon

|k| and r·|D| are compared within 1e-10 of |D|²: that makes the length of A to B the measure. Two points
that are close together and far away need more, long lines past small circles less. Use the extent.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    length = hypot(dx, dy)
    k = abs(dx * fy - dy * fx)
    if abs(k - r * length) <= 1e-10 * length * length:
        return 1
    return 2 if k < r * length else 0
