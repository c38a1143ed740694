"""kept-between-calls

Answers are kept under the four places, and discs of other radii get the answer of the first ones. Make all arguments
the key, or keep nothing.
"""

from math import hypot, sqrt


def balls_meet(P0, P1, r, Q0, Q1, s, known={}):
    key = P0, P1, Q0, Q1
    if key not in known:
        known[key] = meeting(P0, P1, r + s, Q0, Q1)
    return known[key]


def meeting(P0, P1, reach, Q0, Q1):
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
    return first / length if 0 <= first <= length + near else None
