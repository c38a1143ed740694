"""rounded-output

t is rounded to three decimals, as it would be printed. Return it as it is: where t is small, three
decimals are nothing.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    fx, fy = O[0] - cx, O[1] - cy
    dx, dy = D
    n = hypot(dx, dy)
    if n == 0:
        return None
    eps = 1e-10 * max(r, abs(fx), abs(fy))
    d = abs(dx * fy - dy * fx) / n
    if d > r + eps:
        return None
    foot = -(fx * dx + fy * dy) / n
    half = sqrt((r - d) * (r + d)) if d < r - eps else 0
    for s in (foot - half, foot + half):
        if s >= -eps:
            return round(max(s, 0) / n, 3)
    return None
