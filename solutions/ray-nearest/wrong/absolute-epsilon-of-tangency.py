"""absolute-epsilon

The distance of the line is compared with the radius within a fixed 1e-9; only the origin is measured by the
figure. Give both the same slack: 1e-10 of the extent.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    extent = max(r, abs(fx), abs(fy))
    touch, zero = 1e-9, 1e-10 * extent
    d = abs(D[0] * fy - D[1] * fx) / n
    foot = -(fx * D[0] + fy * D[1]) / n
    if d > r + touch:
        return None
    if d >= r - touch:
        roots = [foot]
    else:
        half = sqrt((r - d) * (r + d))
        far = foot + half if foot > 0 else foot - half
        roots = sorted([far, (fx * fx + fy * fy - r * r) / far])
    for s in roots:
        if s >= -zero:
            return 0 if s <= zero else s / n
    return None
