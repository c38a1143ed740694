"""pygeodesy 26.10.26: vector3d.intersections2 with sphere=False

Abutting circles give the same point twice; concentric, invalid or distant ones raise IntersectionError.
"""

from math import hypot

from pygeodesy.vector3d import IntersectionError, Vector3d, intersections2


def circle_circle(cx1, cy1, r1, cx2, cy2, r2):
    if r1 == 0 or r2 == 0 or (cx1, cy1, r1) == (cx2, cy2, r2):
        return with_a_point(cx1, cy1, r1, cx2, cy2, r2)
    try:
        found = intersections2(Vector3d(cx1, cy1, 0), r1, Vector3d(cx2, cy2, 0), r2, sphere=False)
    except (IntersectionError, ValueError):
        found = []
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
