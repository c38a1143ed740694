"""loose-epsilon

The threshold is a millionth of the radius: wider than the promise wherever the radius is most of the
extent. Choose it between the band of the tangents and the promised gap, as a part of the extent.
"""

from math import hypot, isclose


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if isclose(d, r, rel_tol=1e-6):
        return 1
    return 2 if d < r else 0
