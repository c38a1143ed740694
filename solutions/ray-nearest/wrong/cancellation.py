"""cancellation

-b - √Δ subtracts two nearly equal numbers when the origin is close to the circle, and most digits are lost.
Take the root that does not subtract, q = -b - sign(b)·√Δ over a, and the other one as c/q.
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
    k = dx * fy - dy * fx
    gap = r - abs(k) / sqrt(a)
    if gap < -near:
        return None
    root = sqrt(r * r * a - k * k) if gap > near else 0.0
    for t in ((-b - root) / a, (-b + root) / a):
        if t * sqrt(a) >= -near:
            return 0 if t * sqrt(a) <= near else t
    return None
