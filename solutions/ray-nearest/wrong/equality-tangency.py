"""equality-tangency

A tangency is where the discriminant == 0, which floats almost never are.
Call it a tangency when the line's distance and the radius differ by less than 1e-10 of the extent.
"""

import math


def ray_nearest(cx, cy, r, O, D):
    fx, fy = O[0] - cx, O[1] - cy
    dx, dy = D
    a = dx**2 + dy**2
    if a == 0:
        return None
    b = fx * dx + fy * dy
    c = fx**2 + fy**2 - r**2
    disc = r**2 * a - (dx * fy - dy * fx) ** 2
    if disc < 0:
        return None
    if disc == 0:
        ts = [-b / a]
    else:
        q = -b - math.copysign(math.sqrt(disc), b)
        ts = sorted([q / a, c / q])
    near = 1e-10 * max(r, abs(fx), abs(fy)) / math.sqrt(a)
    for t in ts:
        if abs(t) <= near:
            return 0
        if t > 0:
            return t
    return None
