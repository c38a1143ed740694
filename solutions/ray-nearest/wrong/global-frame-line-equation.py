"""global-frame

The distance of the line is the difference of its own offset from the plane's origin and that of the centre.
Far from the origin both are huge and nothing is left of the figure. Subtract C from O first.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    ux, uy = D[0] / n, D[1] / n
    d = abs((ux * O[1] - uy * O[0]) - (ux * cy - uy * cx))
    foot = (ux * cx + uy * cy) - (ux * O[0] + uy * O[1])
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
            return 0 if s <= near else s / n
    return None
