"""kept-between-calls

r²·a and its bound are remembered by the line alone: the next radius gets those of the one before. Remember
nothing, or by all arguments.
"""

from math import inf, nextafter

U = 2.0**-53
known = {}


def delta_enclosure(cx, cy, r, ax, ay, bx, by):
    cx, cy, r, ax, ay, bx, by = map(float, (cx, cy, r, ax, ay, bx, by))
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    reach = known.setdefault((ax, ay, bx, by), r * r * (dx * dx + dy * dy))
    p, q = dx * fy, dy * fx
    k, m = p - q, abs(p) + abs(q)
    bound = U * (12 * reach + 16 * m * abs(k)) + 64 * U * U * m * m
    if bound == 0:
        return 0.0, 0.0
    return nextafter(reach - k * k - bound, -inf), nextafter(reach - k * k + bound, inf)
