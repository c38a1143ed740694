"""loose-epsilon

A line within 3e-7 of the extent of a tangent is called one, a little wider than the promise: some near hits
and misses become tangents. Stay well below the promise's wider band: 1e-10.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    extent = max(r, abs(fx), abs(fy))
    touch, zero = 3e-7 * extent, 1e-10 * extent
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
