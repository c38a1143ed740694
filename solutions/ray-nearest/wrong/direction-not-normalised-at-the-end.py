"""direction-not-normalised

t is found by (m ± h), with the half-chord as a length and the foot as a parameter. Divide both by |D|.
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
    roots = [foot - half * n, foot + half * n]
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
