"""loose-epsilon

A line within a millionth of the extent of a tangent is called one, although the promise separates the two
at a tenth of that. Stay well below the promise's wider band: 1e-10 of the extent.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    fx, fy = O[0] - cx, O[1] - cy
    n = hypot(D[0], D[1])
    if n == 0:
        return None
    e = max(r, abs(fx), abs(fy))
    d = abs(D[0] * fy - D[1] * fx) / n
    foot = -(fx * D[0] + fy * D[1]) / n
    if abs(d - r) <= 1e-6 * e:
        steps = [foot]
    elif d > r:
        return None
    else:
        half = sqrt((r - d) * (r + d))
        far = foot + half if foot > 0 else foot - half
        steps = sorted([far, (fx * fx + fy * fy - r * r) / far])
    for s in steps:
        if s >= -1e-10 * e:
            return 0 if s <= 1e-10 * e else s / n
    return None
