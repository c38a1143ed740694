"""inside-is-miss

If the entry is behind the origin the ray is said to miss, although from inside it meets the circle on its way out.
Go on to the second root.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    d = abs(D[0] * fy - D[1] * fx) / n
    if d > r + near:
        return None
    m = -(fx * D[0] + fy * D[1]) / n
    if d >= r - near:
        s = m
    else:
        h = sqrt((r - d) * (r + d))
        s = (fx * fx + fy * fy - r * r) / (m + h) if m > 0 else m - h
    if s < -near:
        return None
    return max(s, 0) / n
