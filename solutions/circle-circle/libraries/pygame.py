"""pygame-ce 2.5.8: geometry.Circle.intersect

It gives a list of points; a touch is one if both come out as the same.
"""

from math import hypot

from pygame.geometry import Circle


def circle_circle(cx1, cy1, r1, cx2, cy2, r2):
    if r1 == 0 or r2 == 0 or (cx1, cy1, r1) == (cx2, cy2, r2):
        return with_a_point(cx1, cy1, r1, cx2, cy2, r2)
    found = [tuple(p) for p in Circle(cx1, cy1, r1).intersect(Circle(cx2, cy2, r2))]

    side = lambda p: (cx2 - cx1) * (p[1] - cy1) - (cy2 - cy1) * (p[0] - cx1)
    return sorted(set(found), key=side, reverse=True)


def with_a_point(cx1, cy1, r1, cx2, cy2, r2):
    """The answer where a circle is a point, or both are one and the same."""
    if (cx1, cy1, r1) == (cx2, cy2, r2):
        return [(cx1, cy1)] if r1 == 0 else None
    far, near = hypot(cx2 - cx1, cy2 - cy1), r1 or r2
    point = (cx1, cy1) if r1 == 0 else (cx2, cy2)
    return [point] if abs(far - near) <= 1e-9 * max(far, near) else []
