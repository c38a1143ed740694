"""point-for-parameter

The point O + t·D is returned instead of t.
Return the parameter.
"""

from math import copysign, hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
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
            t = max(s, 0) / n
            return (O[0] + t * D[0], O[1] + t * D[1])
    return None
