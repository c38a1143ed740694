"""slope-intercept

Where the slope would be a division by zero it is set to 0: a vertical ray is treated as a horizontal one.
Write it as O + t·D, which knows no special direction.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    m = D[1] / D[0] if D[0] else 0.0
    q = fy - m * fx
    d = abs(q) / sqrt(1 + m * m)
    if d > r + near:
        return None
    root = sqrt((r - d) * (r + d) / (1 + m * m)) if d < r - near else 0.0
    xs = [-m * q / (1 + m * m) - root, -m * q / (1 + m * m) + root]
    roots = sorted((x - fx) * n / (D[0] or 1) for x in xs)
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
