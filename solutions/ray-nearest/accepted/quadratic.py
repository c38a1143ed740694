"""quadratic

The quadratic in t with the discriminant r²a - k² and the roots that do not cancel.
"""

import math


def ray_nearest(cx, cy, r, O, D):
    dx, dy = D
    a = dx * dx + dy * dy
    if a == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    extent = max(r, abs(fx), abs(fy))
    length = math.sqrt(a)
    slack = 1e-10 * extent

    b = fx * dx + fy * dy
    c = fx * fx + fy * fy - r * r
    k = dx * fy - dy * fx
    gap = abs(k) / length - r
    if gap > slack:
        return None
    if abs(gap) <= slack:
        roots = [-b / a]
    else:
        q = -b - math.copysign(math.sqrt(r * r * a - k * k), b)
        roots = sorted([q / a, c / q])

    for t in roots:
        if abs(t) * length <= slack:
            return 0.0
        if t > 0:
            return t
    return None
