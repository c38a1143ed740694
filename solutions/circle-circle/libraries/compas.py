"""compas 2.15.1: intersection_circle_circle_xy

A touch is two identical points; some inner touches raise "math domain error", which is taken for no point.
"""

from math import hypot

from compas.geometry import intersection_circle_circle_xy


def circle_circle(cx1, cy1, r1, cx2, cy2, r2):
    if r1 == 0 or r2 == 0 or (cx1, cy1, r1) == (cx2, cy2, r2):
        return with_a_point(cx1, cy1, r1, cx2, cy2, r2)
    up = (0, 0, 1)
    try:
        found = intersection_circle_circle_xy((((cx1, cy1), up), r1), (((cx2, cy2), up), r2))
    except ValueError:
        found = None
    found = [p[:2] for p in found or ()]

    side = lambda p: (cx2 - cx1) * (p[1] - cy1) - (cy2 - cy1) * (p[0] - cx1)
    return sorted(set(found), key=side, reverse=True)


def with_a_point(cx1, cy1, r1, cx2, cy2, r2):
    """The answer where a circle is a point, or both are one and the same."""
    if (cx1, cy1, r1) == (cx2, cy2, r2):
        return [(cx1, cy1)] if r1 == 0 else None
    far, near = hypot(cx2 - cx1, cy2 - cy1), r1 or r2
    point = (cx1, cy1) if r1 == 0 else (cx2, cy2)
    return [point] if abs(far - near) <= 1e-9 * max(far, near) else []
