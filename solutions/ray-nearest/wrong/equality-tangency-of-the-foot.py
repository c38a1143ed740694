"""equality-tangency

The foot of the perpendicular is computed, and its distance from the centre compared with the radius by ==.
After so many roundings it is hardly ever the same double. Compare within 1e-10 of the extent.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    foot = -(fx * D[0] + fy * D[1]) / n
    d = hypot(fx + foot * D[0] / n, fy + foot * D[1] / n)
    if d > r:
        return None
    if d == r:
        roots = [foot]
    else:
        half = sqrt((r - d) * (r + d))
        far = foot + half if foot > 0 else foot - half
        roots = sorted([far, (fx * fx + fy * fy - r * r) / far])
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
