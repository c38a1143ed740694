"""foot and half-chord, with a tolerance

The foot of the perpendicular, the half-chord, and the power of the origin for the root that would cancel.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    length = hypot(D[0], D[1])
    if length == 0:
        return None
    ux, uy = D[0] / length, D[1] / length
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-9 * max(r, abs(fx), abs(fy))

    distance = abs(D[0] * fy - D[1] * fx) / length
    to_foot = -(fx * ux + fy * uy)
    if distance > r + near:
        return None
    if distance >= r - near:
        first = second = to_foot
    else:
        half_chord = sqrt((r - distance) * (r + distance))
        # The product of the signed lengths to the two points is the power of the origin.
        power = fx * fx + fy * fy - r * r
        if to_foot >= 0:
            second = to_foot + half_chord
            first = power / second
        else:
            first = to_foot - half_chord
            second = power / first
    for where in (first, second):
        if abs(where) <= near:
            return 0
        if where > 0:
            return where / length
    return None
