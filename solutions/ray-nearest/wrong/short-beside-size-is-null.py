"""short-beside-size-is-null

A direction shorter than 1e-10 of the size is taken for none at all. D has no part in the size: its length
says nothing of the figure. Only D = (0, 0) is no direction: compare with == 0.
"""

from math import copysign, hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    if n <= near:
        return None
    d = abs(D[0] * fy - D[1] * fx) / n
    m = -(fx * D[0] + fy * D[1]) / n
    if d > r + near:
        return None
    if d >= r - near:
        roots = [m]
    else:
        outer = m + copysign(sqrt((r - d) * (r + d)), m)
        roots = sorted([outer, (fx * fx + fy * fy - r * r) / outer])
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
