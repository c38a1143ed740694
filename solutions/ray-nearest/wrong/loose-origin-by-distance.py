"""loose-origin

If O is within 1e-5 of the circle, in parts of the extent, 0 is returned, also where O clearly is not on it.
Use a slack well below the promise's wider band: 1e-10 of the extent.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    if abs(hypot(fx, fy) - r) <= 1e5 * near:
        return 0
    d = abs(D[0] * fy - D[1] * fx) / n
    foot = -(fx * D[0] + fy * D[1]) / n
    if d > r + near:
        return None
    if d >= r - near:
        roots = [foot]
    else:
        half = sqrt((r - d) * (r + d))
        far = foot + half if foot > 0 else foot - half
        roots = sorted([far, (fx * fx + fy * fy - r * r) / far])
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
