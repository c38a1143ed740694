"""target-for-direction

D is taken for a second point that the ray passes through.
D is the direction itself: the points are O + t·D.
"""

from math import copysign, hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    dx, dy = D[0] - O[0], D[1] - O[1]
    n = hypot(dx, dy)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    d = abs(dx * fy - dy * fx) / n
    m = -(fx * dx + fy * dy) / n
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
