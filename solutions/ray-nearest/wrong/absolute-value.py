"""absolute-value

The absolute value of the lesser root is returned, and a circle behind the origin is met as well.
A negative t is behind the origin and does not count.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    d = abs(D[0] * fy - D[1] * fx) / n
    m = abs(fx * D[0] + fy * D[1]) / n
    if d > r + near:
        return None
    h = sqrt((r - d) * (r + d)) if d < r - near else 0
    s = m - h if m - h >= -near else m + h
    return 0 if s <= near else s / n
