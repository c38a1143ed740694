"""radius-not-squared

The half-chord is √(r − d²), with the radius as it is. Square the radius.
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
    if d * d > r:
        return None
    half = sqrt(r - d * d)
    roots = [foot - half, foot + half]
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
