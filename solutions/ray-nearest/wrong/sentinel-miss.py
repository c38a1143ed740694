"""sentinel-miss

A miss is reported as -1.
Return None: -1 is a number like any other.
"""

from math import copysign, hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return -1
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    d = abs(D[0] * fy - D[1] * fx) / n
    m = -(fx * D[0] + fy * D[1]) / n
    if d > r + near:
        return -1
    if d >= r - near:
        roots = (m,)
    else:
        outer = m + copysign(sqrt((r - d) * (r + d)), m)
        roots = sorted((outer, (fx * fx + fy * fy - r * r) / outer))
    for s in roots:
        if s >= -near:
            return max(s, 0) / n
    return -1
