"""ezdxf 1.4.5: ConstructionCircle.intersect_ray

Its ray is an infinite line, so what lies behind O is left out here. A touch is one point within 1e-10.
"""

from math import hypot

from ezdxf.math import ConstructionCircle, ConstructionRay


def ray_nearest(cx, cy, r, O, D):
    if D == (0, 0):
        return None
    if r == 0:
        return at_a_point(cx, cy, O, D)
    found = ConstructionCircle((cx, cy), r).intersect_ray(ConstructionRay(O, (O[0] + D[0], O[1] + D[1])))
    times = (((p.x - O[0]) * D[0] + (p.y - O[1]) * D[1]) / (D[0] * D[0] + D[1] * D[1]) for p in found)
    return min((t for t in times if t >= 0), default=None)


def at_a_point(cx, cy, O, D):
    """t where the circle is the point C; None where the ray misses it."""
    t = ((cx - O[0]) * D[0] + (cy - O[1]) * D[1]) / (D[0] * D[0] + D[1] * D[1])
    off = hypot(O[0] + t * D[0] - cx, O[1] + t * D[1] - cy)
    return t if t >= 0 and off <= 1e-9 * hypot(cx - O[0], cy - O[1]) else None
