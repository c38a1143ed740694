"""cadquery-ocp 8.0.1.1.0: IntAna2d_AnaIntersection of two gp_Circ2d

No tolerance can be given. A touch is one point, but in tiny figures, where some touches have none.
"""

from math import hypot

from OCP.gp import gp_Ax2d, gp_Circ2d, gp_Dir2d, gp_Pnt2d
from OCP.IntAna2d import IntAna2d_AnaIntersection


def circle_circle(cx1, cy1, r1, cx2, cy2, r2):
    if r1 == 0 or r2 == 0 or (cx1, cy1, r1) == (cx2, cy2, r2):
        return with_a_point(cx1, cy1, r1, cx2, cy2, r2)
    one, two = (
        gp_Circ2d(gp_Ax2d(gp_Pnt2d(x, y), gp_Dir2d(1, 0)), r)
        for x, y, r in ((cx1, cy1, r1), (cx2, cy2, r2))
    )
    points = IntAna2d_AnaIntersection(one, two)
    places = (points.Point(number).Value() for number in range(1, points.NbPoints() + 1))
    found = [(p.X(), p.Y()) for p in places]

    side = lambda p: (cx2 - cx1) * (p[1] - cy1) - (cy2 - cy1) * (p[0] - cx1)
    return sorted(set(found), key=side, reverse=True)


def with_a_point(cx1, cy1, r1, cx2, cy2, r2):
    """The answer where a circle is a point, or both are one and the same."""
    if (cx1, cy1, r1) == (cx2, cy2, r2):
        return [(cx1, cy1)] if r1 == 0 else None
    far, near = hypot(cx2 - cx1, cy2 - cy1), r1 or r2
    point = (cx1, cy1) if r1 == 0 else (cx2, cy2)
    return [point] if abs(far - near) <= 1e-9 * max(far, near) else []
