"""radical line, with a tolerance

Subtract the two equations: what is left is a line, and it cuts the first circle where the second does.

Seen from C1, with v = C2 − C1 and d = |v|, the equations are X·X = r1² and X·X − 2·X·v + d² = r2². Their
difference says that the line is at right angles to v, a = (d² + r1² − r2²)/(2d) away from C1; half the chord is
√(r1² − a²). The left of v is (−vy, vx).

All the cases are told apart before that, by lengths and within 1e-9 of the size: one centre, a touch from
outside (d = r1 + r2) or from inside (d = |r1 − r2|), no point at all.
"""

from math import hypot, sqrt


def circle_circle(cx1, cy1, r1, cx2, cy2, r2):
    vx, vy = cx2 - cx1, cy2 - cy1
    near = 1e-9 * max(r1, r2, abs(vx), abs(vy))
    d = hypot(vx, vy)
    if d <= near:
        if r1 == r2 == 0:
            return [(cx1, cy1)]
        return None if abs(r1 - r2) <= near else []
    ux, uy = vx / d, vy / d
    if abs(d - (r1 + r2)) <= near:
        return [(cx1 + r1 * ux, cy1 + r1 * uy)]
    if abs(d - abs(r1 - r2)) <= near:
        side = r1 if r1 > r2 else -r1
        return [(cx1 + side * ux, cy1 + side * uy)]
    if d > r1 + r2 or d < abs(r1 - r2):
        return []
    a = (d + (r1 - r2) * ((r1 + r2) / d)) / 2
    h = sqrt(max(0.0, (r1 - a) * (r1 + a)))
    return [
        (cx1 + a * ux - h * uy, cy1 + a * uy + h * ux),
        (cx1 + a * ux + h * uy, cy1 + a * uy - h * ux),
    ]
