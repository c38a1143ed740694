"""distance-for-parameter

The direction is normalised, and what is returned is a distance, not t; by −m ± h moreover. Divide by |D|.
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
    half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
    roots = [foot - half, foot + half]
    for s in roots:
        if s >= -near:
            return max(s, 0.0)
    return None
