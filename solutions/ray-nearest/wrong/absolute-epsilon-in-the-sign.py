"""absolute-epsilon

The sign that keeps the stable formula from subtracting is taken to be 0, that is +, below 1e-9: on a small figure
b always is, and the formula subtracts again. A sign needs no epsilon; a band is a part of the extent.
"""

import math


def ray_nearest(cx, cy, r, O, D):
    dx, dy = D
    a = dx * dx + dy * dy
    if a == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    slack = 1e-10 * max(r, abs(fx), abs(fy))
    length = math.sqrt(a)
    b = fx * dx + fy * dy
    k = dx * fy - dy * fx
    gap = abs(k) / length - r
    if gap > slack:
        return None
    if gap >= -slack:
        ts = [-b / a]
    else:
        sign = -1 if b < -1e-9 else 1
        q = -(b + sign * math.sqrt(r * r * a - k * k))
        ts = sorted([q / a, (fx * fx + fy * fy - r * r) / q])
    for t in ts:
        if abs(t) * length <= slack:
            return 0.0
        if t > 0:
            return t
    return None
