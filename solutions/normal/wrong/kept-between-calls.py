"""kept-between-calls

The hit is kept under the circle and the origin, so that another direction gets the normal of the first one. Make all
arguments the key, or keep nothing.
"""

from math import hypot, sqrt


def hit_normal(cx, cy, r, O, D, known={}):
    key = cx, cy, r, O
    if key not in known:
        known[key] = normal(O[0] - cx, O[1] - cy, r, D)
    return known[key]


def normal(fx, fy, r, D):
    length = hypot(*D)
    if not length or not r:
        return None
    ux, uy = D[0] / length, D[1] / length
    near = 1e-10 * max(r, abs(fx), abs(fy))
    d, foot = abs(ux * fy - uy * fx), -(ux * fx + uy * fy)
    if d > r + near:
        return None
    half = sqrt((r - d) * (r + d)) if d < r - near else 0
    way, side = foot - half, 1
    if way < -near:
        way, side = foot + half, -1
    return None if way < -near else (side * (fx + way * ux) / r, side * (fy + way * uy) / r)
