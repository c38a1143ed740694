"""sqrt-of-negative

The absolute value is taken under the root, "to be safe", so that a line that misses the circle meets it as
well. A negative number there means that there is no common point.
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
    half = sqrt(abs((r - d) * (r + d))) if abs(d - r) > near else 0.0
    roots = [foot - half, foot + half]
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
