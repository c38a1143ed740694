"""sign-of-zero

The stable formula uses a sign that is 0 for b = 0, and both roots become 0 or a division by it.
Take the sign of 0 as +1 (or use copysign).
"""

from math import sqrt


def ray_nearest(cx, cy, r, O, D):
    dx, dy = D
    fx, fy = O[0] - cx, O[1] - cy
    a = dx * dx + dy * dy
    if a == 0:
        return None
    near = 1e-10 * max(r, abs(fx), abs(fy))
    b = fx * dx + fy * dy
    c = fx * fx + fy * fy - r * r
    k = dx * fy - dy * fx
    gap = r - abs(k) / sqrt(a)
    if gap < -near:
        return None
    if gap <= near:
        ts = [-b / a]
    else:
        sign = 1 if b > 0 else -1 if b < 0 else 0
        q = -b - sign * sqrt(r * r * a - k * k)
        ts = sorted([q / a, c / q])
    for t in ts:
        if t * sqrt(a) >= -near:
            return 0 if t * sqrt(a) <= near else t
    return None
