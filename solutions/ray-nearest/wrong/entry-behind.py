"""entry-behind

The lesser root is returned even where it is negative.
Skip a root behind the origin and look at the other one.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(D[0], D[1])
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    d = abs(D[0] * fy - D[1] * fx) / n
    m = -(fx * D[0] + fy * D[1]) / n
    if d > r + near:
        return None
    h = sqrt((r - d) * (r + d)) if d < r - near else 0
    s = m - h
    return 0 if abs(s) <= near else s / n
