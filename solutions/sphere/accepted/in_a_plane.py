"""in a plane

The ray and the centre span a plane: there the sphere is a circle. Seen along the ray's unit vector u and the unit
vector w from the line to the centre, the centre is at (m, d), and the points are at the angles whose sine is d/r.
"""

from math import asin, cos, hypot, sin


def ray_sphere(C, r, O, D):
    size = max(map(abs, D))
    if size == 0 or r == 0:
        return None
    scaled = [x / size for x in D]
    length = hypot(*scaled)
    u = [x / length for x in scaled]
    g = [c - o for c, o in zip(C, O)]
    m = sum(x * y for x, y in zip(g, u))
    across = [x - m * y for x, y in zip(g, u)]
    d = hypot(*across)
    reach = max(r, *map(abs, g))
    if d > r + 1e-10 * reach:
        return None
    touches = d >= r - 1e-10 * reach
    w = [x / d for x in across] if d else [0.0, 0.0, 0.0]
    angle = 0.0 if touches else asin(d / r)
    for side in (-1, 1):
        along = 0.0 if touches else side * r * cos(angle)
        way = m + along
        if way < -1e-10 * reach:
            continue
        beside = 1.0 if touches else sin(angle)
        ahead = 0.0 if touches else side * cos(angle)
        outward = [ahead * x - beside * y for x, y in zip(u, w)]
        facing = outward if touches or side < 0 else [-x for x in outward]
        t = 0.0 if way <= 1e-10 * reach else way / length / size
        return t, tuple(facing)
    return None
