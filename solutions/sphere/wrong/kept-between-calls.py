"""kept-between-calls

Answers are kept in a dict whose key is the ray alone, so that another sphere gets those of the first one. Make all
arguments the key, or keep nothing.
"""

from math import hypot, sqrt

known = {}


def ray_sphere(C, r, O, D):
    if (O, D) not in known:
        known[O, D] = found(C, r, O, D)
    return known[O, D]


def found(C, r, O, D):
    length = hypot(*D)
    if length == 0 or r == 0:
        return None
    u = [x / length for x in D]
    f = [o - c for o, c in zip(O, C)]
    near = 1e-10 * max(r, *map(abs, f))
    d = hypot(u[1] * f[2] - u[2] * f[1], u[2] * f[0] - u[0] * f[2], u[0] * f[1] - u[1] * f[0])
    if d > r + near:
        return None
    half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
    m = -sum(x * y for x, y in zip(u, f))
    for way, side in ((m - half, 1), (m + half, -1)):
        if way >= -near:
            return max(way, 0.0) / length, [side * (x + way * y) / r for x, y in zip(f, u)]
    return None
