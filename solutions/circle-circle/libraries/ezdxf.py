"""ezdxf 1.4.5: ConstructionCircle.intersect_circle

Outside of r1 + r2 and |r1 - r2| there is no point, without any room; a touch is one point within 1e-10.
"""

from math import hypot

from ezdxf.math import ConstructionCircle


def circle_circle(cx1, cy1, r1, cx2, cy2, r2):
    if r1 == 0 or r2 == 0 or (cx1, cy1, r1) == (cx2, cy2, r2):
        return with_a_point(cx1, cy1, r1, cx2, cy2, r2)
    found = ConstructionCircle((cx1, cy1), r1).intersect_circle(ConstructionCircle((cx2, cy2), r2))
    found = [(p.x, p.y) for p in found]

    side = lambda p: (cx2 - cx1) * (p[1] - cy1) - (cy2 - cy1) * (p[0] - cx1)
    return sorted(set(found), key=side, reverse=True)


def with_a_point(cx1, cy1, r1, cx2, cy2, r2):
    """The answer where a circle is a point, or both are one and the same."""
    if (cx1, cy1, r1) == (cx2, cy2, r2):
        return [(cx1, cy1)] if r1 == 0 else None
    far, near = hypot(cx2 - cx1, cy2 - cy1), r1 or r2
    point = (cx1, cy1) if r1 == 0 else (cx2, cy2)
    return [point] if abs(far - near) <= 1e-9 * max(far, near) else []
