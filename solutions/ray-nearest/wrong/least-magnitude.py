"""least-magnitude

Of the two roots the one nearest to 0 is taken, on whichever side of the origin it is.
Drop what is behind first, then take the least.
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
        roots = [outer, (fx * fx + fy * fy - r * r) / outer]
    s = min(roots, key=abs)
    if abs(s) <= near:
        return 0
    return s / n if s > 0 else None
