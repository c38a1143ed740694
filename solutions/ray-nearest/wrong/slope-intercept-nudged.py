"""slope-intercept

A vertical ray is given a slope by moving D a little to the side. Write it as O + t·D, which knows no
special direction.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    dx = D[0] or 1e-9
    m = D[1] / dx
    q = fy - m * fx
    d = abs(q) / sqrt(1 + m * m)
    if d > r + near:
        return None
    root = sqrt((r - d) * (r + d) / (1 + m * m)) if d < r - near else 0.0
    xs = [-m * q / (1 + m * m) - root, -m * q / (1 + m * m) + root]
    roots = sorted((x - fx) * n / dx for x in xs)
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
