"""absolute-epsilon

The discriminant, which is a fourth power of a length, is compared with 1e-9.
Compare lengths instead, the distance of the line with the radius, with a small part of the extent.
"""

from math import copysign, sqrt


def ray_nearest(cx, cy, r, O, D):
    dx, dy = D
    a = dx * dx + dy * dy
    if a == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    b = fx * dx + fy * dy
    c = fx * fx + fy * fy - r * r
    disc = r * r * a - (dx * fy - dy * fx) ** 2
    if disc < -1e-9:
        return None
    if disc < 1e-9:
        ts = [-b / a]
    else:
        q = -b - copysign(sqrt(disc), b)
        ts = sorted((q / a, c / q))
    slack = 1e-10 * max(r, abs(fx), abs(fy)) / sqrt(a)
    for t in ts:
        if t >= -slack:
            return 0 if t <= slack else t
    return None
