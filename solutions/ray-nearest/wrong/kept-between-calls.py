"""kept-between-calls

The best t so far is kept in a global, and a later call is given that of an earlier one.
Keep it in a local variable.
"""

from math import copysign, hypot, inf, sqrt

best = inf


def ray_nearest(cx, cy, r, O, D):
    global best
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
        roots = [outer, (fx * fx + fy * fy - r * r) / outer]
    for s in roots:
        if s >= -near:
            best = min(best, max(s, 0) / n)
    return best if best < inf else None
