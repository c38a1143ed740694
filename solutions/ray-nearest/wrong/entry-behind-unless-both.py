"""entry-behind

A negative entry is returned unless both points are behind the origin. Skip a root behind the origin and
look at the other one.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    d = abs(D[0] * fy - D[1] * fx) / n
    foot = -(fx * D[0] + fy * D[1]) / n
    if d > r + near:
        return None
    if d >= r - near:
        roots = [foot]
    else:
        half = sqrt((r - d) * (r + d))
        far = foot + half if foot > 0 else foot - half
        roots = sorted([far, (fx * fx + fy * fy - r * r) / far])
    if roots[-1] < -near:
        return None
    return 0 if abs(roots[0]) <= near else roots[0] / n
