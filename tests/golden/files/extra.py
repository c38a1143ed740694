"""exact-for-ints

Ints are compared exactly, and only floats within the band. The statement's band is the same for both types: circles
that are 1e-12 of the extent off a touch do touch, in ints as well.
"""

from math import hypot, sqrt


def circle_circle(cx1, cy1, r1, cx2, cy2, r2):
    vx, vy = cx2 - cx1, cy2 - cy1
    square, d = vx * vx + vy * vy, hypot(vx, vy)
    exact = isinstance(square + r1 + r2, int)
    near = 1e-10 * max(r1, r2, d)

    def against(reach):
        if exact:
            return (square > reach * reach) - (square < reach * reach)
        return (d > reach + near) - (d < reach - near)

    if against(0) == 0:
        if r1 == r2 == 0:
            return [(cx1, cy1)]
        return None if abs(r1 - r2) <= near else []
    outer, inner = against(r1 + r2), against(abs(r1 - r2))
    if outer > 0 or inner < 0:
        return []
    ux, uy = vx / d, vy / d
    if outer == 0 or inner == 0:
        s = r1 if outer == 0 or r1 > r2 else -r1
        return [(cx1 + s * ux, cy1 + s * uy)]
    a = (d + (r1 - r2) * ((r1 + r2) / d)) / 2
    h = sqrt(max(0.0, (r1 - a) * (r1 + a)))
    return [(cx1 + a * ux - s * uy, cy1 + a * uy + s * ux) for s in (h, -h)]
