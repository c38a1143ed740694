"""relative motion

Sit on the second disc: it rests, and the first one moves along D, the difference of both ways. Blow the second
disc up to r + s, and shrink the first one to a point: when does a ray meet a circle? Where the ray's line is
farther away than r + s, never. Else step back from the foot of the perpendicular by half the chord.
"""

from math import hypot, sqrt


def balls_meet(P0, P1, r, Q0, Q1, s):
    reach = r + s
    fx, fy = P0[0] - Q0[0], P0[1] - Q0[1]
    dx, dy = (P1[0] - P0[0]) - (Q1[0] - Q0[0]), (P1[1] - P0[1]) - (Q1[1] - Q0[1])
    ways = P1[0] - P0[0], P1[1] - P0[1], fx, fy, Q1[0] - P0[0], Q1[1] - P0[1]
    near = 1e-10 * max(reach, *map(abs, ways))
    if hypot(fx, fy) <= reach + near:
        return 0
    length = hypot(dx, dy)
    if length == 0:
        return None
    d = abs(dx * fy - dy * fx) / length
    if d > reach + near:
        return None
    foot = -(dx * fx + dy * fy) / length
    first = foot if d >= reach - near else foot - sqrt((reach - d) * (reach + d))
    if first < 0 or first > length + near:
        return None
    return first / length
