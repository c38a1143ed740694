"""sqrt-of-negative

Under the root stands max(0, r² − d²), so that a line that misses the circle meets it at the foot. A
negative number there means that there is no common point: return None before taking the root.
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
    half = sqrt(max(0.0, (r - d) * (r + d)))
    if d >= r - near:
        roots = [foot]
    else:
        far = foot + half if foot > 0 else foot - half
        roots = sorted([far, (fx * fx + fy * fy - r * r) / far])
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
