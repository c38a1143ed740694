"""no-snap

Tangencies have their epsilon, but t >= 0 is taken to the letter, and rounding pushes a root at the origin behind it.
Let the origin have the same slack, as a length: |t|·|D| <= 1e-10 of the extent is t = 0.
"""

from math import sqrt


def ray_nearest(cx, cy, r, O, D):
    dx, dy = D
    fx, fy = O[0] - cx, O[1] - cy
    a = dx * dx + dy * dy
    if a == 0:
        return None
    b = fx * dx + fy * dy
    c = fx * fx + fy * fy - r * r
    k = dx * fy - dy * fx
    near = 1e-10 * max(r, abs(fx), abs(fy))
    gap = r - abs(k) / sqrt(a)
    if gap < -near:
        return None
    if gap <= near:
        ts = [-b / a]
    else:
        root = sqrt(r * r * a - k * k)
        q = -b - root if b > 0 else -b + root
        ts = sorted([q / a, c / q])
    for t in ts:
        if t >= 0:
            return t
    return None
