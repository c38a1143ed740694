"""global-frame

The point of contact is computed in the plane's own coordinates, and t is found from it. Far from the origin
a coordinate has few digits left for it. Compute t from the differences.
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
    for s in roots:
        if s >= -near:
            x, y = O[0] + s * D[0] / n, O[1] + s * D[1] / n
            return 0 if s <= near else (x - O[0]) / D[0] if abs(D[0]) > abs(D[1]) else (y - O[1]) / D[1]
    return None
