"""cancellation

(−b ± √(b² − 4ac))/2a, as in the textbook: close to the circle −b − √ subtracts two nearly equal numbers.
Take the root that does not subtract, and the other one from c.
"""

from math import sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    dx, dy = D
    a = dx * dx + dy * dy
    if a == 0:
        return None
    n = sqrt(a)
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    k = dx * fy - dy * fx
    b = 2 * (fx * dx + fy * dy)
    c = fx * fx + fy * fy - r * r
    d = abs(k) / n
    if d > r + near:
        return None
    root = sqrt(4 * (r * r * a - k * k)) if d < r - near else 0.0
    ts = [(-b - root) / (2 * a), (-b + root) / (2 * a)]
    for t in ts:
        if abs(t) * n <= near:
            return 0.0
        if t > 0:
            return t
    return None
