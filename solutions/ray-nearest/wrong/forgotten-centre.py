"""forgotten-centre

The circle is taken to stand at the origin, wherever its centre is.
Subtract C from O first.
"""

from math import copysign, hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    x, y = O
    near = 1e-10 * max(r, abs(x), abs(y))
    d = abs(D[0] * y - D[1] * x) / n
    m = -(x * D[0] + y * D[1]) / n
    if d > r + near:
        return None
    if d >= r - near:
        roots = [m]
    else:
        outer = m + copysign(sqrt((r - d) * (r + d)), m)
        roots = sorted([outer, (x * x + y * y - r * r) / outer])
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
