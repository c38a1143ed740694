"""absolute-epsilon

d² and r² are compared within a fixed 1e-9, which is an area. Compare lengths, and with a small part of the
extent.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    square = (D[0] * fy - D[1] * fx) ** 2 / n**2
    foot = -(fx * D[0] + fy * D[1]) / n
    if square > r * r + 1e-9:
        return None
    if square >= r * r - 1e-9:
        roots = [foot]
    else:
        half = sqrt(r * r - square)
        far = foot + half if foot > 0 else foot - half
        roots = sorted([far, (fx * fx + fy * fy - r * r) / far])
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
