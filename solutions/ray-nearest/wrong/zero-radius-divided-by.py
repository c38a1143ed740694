"""zero-radius

All lengths are divided by the radius, to make it 1: for r = 0 that is a division by zero. Divide by the
extent, or by nothing.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    fx, fy, n = fx / r, fy / r, n / r
    near = 1e-10 * max(1, abs(fx), abs(fy))
    d = abs(D[0] * fy - D[1] * fx) / (n * r)
    foot = -(fx * D[0] + fy * D[1]) / (n * r)
    if d > 1 + near:
        return None
    if d >= 1 - near:
        roots = [foot]
    else:
        half = sqrt((1 - d) * (1 + d))
        far = foot + half if foot > 0 else foot - half
        away = hypot(fx, fy)
        roots = sorted([far, (away - 1) * (away + 1) / far])
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
