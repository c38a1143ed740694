"""the widest tolerance

All lengths are compared with 1e-8 of the size: the distance at the start, the least one, and the way that is left.
"""

from math import hypot, sqrt


def balls_meet(P0, P1, r, Q0, Q1, s):
    fx, fy = P0[0] - Q0[0], P0[1] - Q0[1]
    vx, vy = P1[0] - P0[0], P1[1] - P0[1]
    dx, dy = vx - (Q1[0] - Q0[0]), vy - (Q1[1] - Q0[1])
    near = 1e-8 * max(r + s, *map(abs, (fx, fy, vx, vy, Q1[0] - P0[0], Q1[1] - P0[1])))
    if hypot(fx, fy) <= r + s + near:
        return 0
    way = hypot(dx, dy)
    if way == 0:
        return None
    d, foot = abs(dx * fy - dy * fx) / way, -(dx * fx + dy * fy) / way
    if d > r + s + near:
        return None
    first = foot - (sqrt((r + s - d) * (r + s + d)) if d < r + s - near else 0.0)
    return None if first < 0 or first > way + near else first / way
