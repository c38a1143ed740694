"""distance-for-parameter

The distance from the origin to the point is returned, which is t only where |D| = 1.
Divide it by |D|.
"""

from math import copysign, hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    ux, uy = D[0] / n, D[1] / n
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    d = abs(ux * fy - uy * fx)
    m = -(fx * ux + fy * uy)
    if d > r + near:
        return None
    if d >= r - near:
        roots = [m]
    else:
        outer = m + copysign(sqrt((r - d) * (r + d)), m)
        roots = sorted([outer, (fx * fx + fy * fy - r * r) / outer])
    for s in roots:
        if s >= -near:
            return max(s, 0)
    return None
