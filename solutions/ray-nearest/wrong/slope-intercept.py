"""slope-intercept

The line is written y = m·x + q, which a vertical one cannot be; its ray divides by zero.
Write it as O + t·D, which knows no special direction.
"""

from math import sqrt


def ray_nearest(cx, cy, r, O, D):
    if D[0] == 0 and D[1] == 0:
        return None
    x0, y0 = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(x0), abs(y0))
    m = D[1] / D[0]
    q = y0 - m * x0
    gap = r - abs(q) / sqrt(1 + m * m)
    if gap < -near:
        return None
    root = sqrt(r * r * (1 + m * m) - q * q) if gap > near else 0
    ts = sorted(((-m * q + side * root) / (1 + m * m) - x0) / D[0] for side in (-1, 1))
    slack = near / sqrt(D[0] ** 2 + D[1] ** 2)
    for t in ts:
        if t >= -slack:
            return 0 if t <= slack else t
    return None
