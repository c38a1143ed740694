"""hit from the centre, with a tolerance

The point of the hit as seen from C is r long: divided by r it is the normal that points outward.

Nothing is added to C, for the point itself is not asked for: far from the origin it would have no digits left. The
foot of the perpendicular and half the chord are lengths along the ray. If the first of both points is behind O, the
ray begins inside and leaves at the second: there D·N > 0, and the normal is flipped.

All decisions are lengths beside 1e-9 of the size: a miss, a touch, and how far ahead of O a point is.
"""

from math import hypot, sqrt


def hit_normal(cx, cy, r, O, D):
    length = hypot(*D)
    if r == 0 or length == 0:
        return None
    ux, uy = D[0] / length, D[1] / length
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-9 * max(r, abs(fx), abs(fy))

    distance = abs(D[0] * fy - D[1] * fx) / length
    if distance > r + near:
        return None
    to_foot = -(fx * ux + fy * uy)
    half = sqrt((r - distance) * (r + distance)) if distance < r - near else 0
    for way in (to_foot - half, to_foot + half):
        if way >= -near:
            nx, ny = (fx + way * ux) / r, (fy + way * uy) / r
            leaves = half and nx * ux + ny * uy > 0
            return (-nx, -ny) if leaves else (nx, ny)
    return None
