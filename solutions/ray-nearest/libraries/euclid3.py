"""euclid3 0.1: Ray2.intersect(Circle)

Its circle is a disc: it gives the part of the ray that lies in it. From inside that part begins at O.
"""

from math import hypot

from euclid3 import Circle, Point2, Ray2, Vector2


def ray_nearest(cx, cy, r, O, D):
    if D == (0, 0):
        return None
    if r == 0:
        return at_a_point(cx, cy, O, D)
    found = Ray2(Point2(*map(float, O)), Vector2(*map(float, D))).intersect(Circle(Point2(cx, cy), float(r)))
    if found is None:
        return None
    ends = [found] if isinstance(found, Point2) else [found.p1, found.p2]
    return min(((p.x - O[0]) * D[0] + (p.y - O[1]) * D[1]) / (D[0] * D[0] + D[1] * D[1]) for p in ends)


def at_a_point(cx, cy, O, D):
    """t where the circle is the point C; None where the ray misses it."""
    t = ((cx - O[0]) * D[0] + (cy - O[1]) * D[1]) / (D[0] * D[0] + D[1] * D[1])
    off = hypot(O[0] + t * D[0] - cx, O[1] + t * D[1] - cy)
    return t if t >= 0 and off <= 1e-9 * hypot(cx - O[0], cy - O[1]) else None
