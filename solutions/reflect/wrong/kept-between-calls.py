"""kept-between-calls

The hit is kept under the circle and the origin, so that another direction gets the answer of the first one. Make all
arguments the key, or keep nothing.
"""

from math import hypot, sqrt


def reflect(cx, cy, r, O, D, known={}):
    key = cx, cy, r, O
    if key not in known:
        known[key] = reflected(O[0] - cx, O[1] - cy, r, O, D)
    return known[key]


def reflected(fx, fy, r, O, D):
    length = hypot(*D)
    if not length or not r:
        return None
    ux, uy = D[0] / length, D[1] / length
    near = 1e-10 * max(r, abs(fx), abs(fy))
    d, foot = abs(ux * fy - uy * fx), -(ux * fx + uy * fy)
    if d > r + near:
        return None
    half = sqrt((r - d) * (r + d)) if d < r - near else 0
    way = foot - half if foot - half >= -near else foot + half
    if way < -near:
        return None
    nx, ny = (fx + way * ux) / r, (fy + way * uy) / r
    twice = 2 * (D[0] * nx + D[1] * ny)
    return (O[0] + way * ux, O[1] + way * uy), (D[0] - twice * nx, D[1] - twice * ny)
