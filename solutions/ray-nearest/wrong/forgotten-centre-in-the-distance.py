"""forgotten-centre

The distance of the line is taken from the plane's origin and not from C; the rest is right. Subtract C from
O first.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    d = abs(D[0] * O[1] - D[1] * O[0]) / n
    foot = -(fx * D[0] + fy * D[1]) / n
    if d > r + near:
        return None
    half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
    roots = [foot - half, foot + half]
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
