"""normal part, with a tolerance

Two parts of D: along the normal and across it. The one along the normal turns round, the other one stays.

The normal is N = (P − C)/r, and (D·N)N is the part of D along it: taken away once, the ray would slide along the
circle; taken away twice, it is reflected. N goes in twice, so its sign does not matter, and inside is no other case
than outside. But it must be 1 long, while D may have any length, which it keeps.

At a touch D·N is 0, and D stays as it is.
"""

from math import hypot, sqrt


def reflect(cx, cy, r, O, D):
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
            twice = 2 * (D[0] * nx + D[1] * ny)
            return (O[0] + way * ux, O[1] + way * uy), (D[0] - twice * nx, D[1] - twice * ny)
    return None
