"""pymunk 7.3.1: Circle.segment_query, on a segment that reaches beyond the circle

Its circle is a disc: a query that starts inside ends at once, with alpha 0.
"""

from math import hypot

import pymunk


def ray_nearest(cx, cy, r, O, D):
    if D == (0, 0):
        return None
    if r == 0:
        return at_a_point(cx, cy, O, D)
    k = (hypot(cx - O[0], cy - O[1]) + 2 * r) / hypot(*D)
    space = pymunk.Space()
    circle = pymunk.Circle(space.static_body, r, (cx, cy))
    space.add(circle)
    found = circle.segment_query(O, (O[0] + k * D[0], O[1] + k * D[1]))
    return found.alpha * k if found else None


def at_a_point(cx, cy, O, D):
    """t where the circle is the point C; None where the ray misses it."""
    t = ((cx - O[0]) * D[0] + (cy - O[1]) * D[1]) / (D[0] * D[0] + D[1] * D[1])
    off = hypot(O[0] + t * D[0] - cx, O[1] + t * D[1] - cy)
    return t if t >= 0 and off <= 1e-9 * hypot(cx - O[0], cy - O[1]) else None
