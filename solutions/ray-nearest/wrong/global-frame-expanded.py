"""global-frame

c is expanded into |O|² − 2·O·C + |C|² − r², and far from the origin nothing is left of it, nor of the root
that is c/q. Subtract C from O first, and compute with the difference.
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
        x, y = float(O[0]), float(O[1])
        c = x * x + y * y - 2 * (x * cx + y * cy) + cx * cx + cy * cy - r * r
        half = sqrt((r - d) * (r + d))
        far = foot + half if foot > 0 else foot - half
        roots = sorted([far, c / far])
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
