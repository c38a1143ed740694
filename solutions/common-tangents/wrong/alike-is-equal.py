"""alike-is-equal

Radii that differ by little are taken for equal, and the outer tangents for parallel to C1C2. With n·v = r1 − r2 there is
no need to ask.
"""

from math import hypot, sqrt


def common_tangents(cx1, cy1, r1, cx2, cy2, r2):
    vx, vy = cx2 - cx1, cy2 - cy1
    d = hypot(vx, vy)
    eps = 1e-10 * max(r1, r2, abs(vx), abs(vy))
    ux, uy = vx / d, vy / d

    def at(along, left):
        return (cx1 + r1 * (along * ux - left * uy), cy1 + r1 * (along * uy + left * ux))

    less, more = r1 - r2, r1 + r2
    if abs(d - abs(less)) <= eps:
        return [at(1, 0) if less > 0 else at(-1, 0)]
    if d < abs(less):
        return []
    if abs(less) < 1e-6 * max(r1, r2):
        less = 0
    c = less / d
    s = sqrt((d - less) * (d + less)) / d
    points = [at(c, s), at(c, -s)]
    if abs(d - more) <= eps:
        points.append(at(1, 0))
    elif d > more:
        c = more / d
        s = sqrt((d - more) * (d + more)) / d
        points += [at(c, s), at(c, -s)]
    return points
