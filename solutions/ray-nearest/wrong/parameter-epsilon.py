"""parameter-epsilon

t itself is compared with an epsilon, but how long a step of t is depends on D.
Compare the length |t|·|D| with a small part of the extent.
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
    k = dx * fy - dy * fx
    gap = r - abs(k) / sqrt(a)
    near = 1e-10 * max(r, abs(fx), abs(fy))
    if gap < -near:
        return None
    if gap <= near:
        ts = [-b / a]
    else:
        q = -b - copysign(sqrt(r * r * a - k * k), b)
        ts = sorted([q / a, c / q])
    for t in ts:
        if abs(t) < 1e-9:
            return 0
        if t > 0:
            return t
    return None
