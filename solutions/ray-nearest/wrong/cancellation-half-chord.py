"""cancellation

The half-chord is subtracted from the distance to the foot; close to the circle the two are nearly equal.
Find the far point first, and the near one from the power of the origin: near · far = f·f - r².
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    length = hypot(*D)
    if length == 0:
        return None
    ux, uy = D[0] / length, D[1] / length
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    offset = abs(ux * fy - uy * fx)
    foot = -(fx * ux + fy * uy)
    if offset > r + near:
        return None
    half = sqrt((r - offset) * (r + offset)) if offset < r - near else 0.0
    for where in (foot - half, foot + half):
        if where >= -near:
            return 0.0 if where <= near else where / length
    return None
