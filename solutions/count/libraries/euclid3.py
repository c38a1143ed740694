"""euclid3 0.1: Line2.intersect(Circle)

A touch is one point if both parameters are the same float; the discriminant is compared with 0.
"""

from math import hypot

from euclid3 import Circle, Line2, Point2


def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    if r == 0:
        return int(on_line(cx, cy, A, B))
    found = Line2(Point2(*A), Point2(*B)).intersect(Circle(Point2(cx, cy), float(r)))
    return 0 if found is None else 1 if isinstance(found, Point2) else 2


def on_line(cx, cy, A, B):
    """Whether the point C, the circle of radius 0, is on the line."""
    ux, uy, wx, wy = B[0] - A[0], B[1] - A[1], cx - A[0], cy - A[1]
    size = max(map(abs, (wx, wy, cx - B[0], cy - B[1])))
    return abs(ux * wy - uy * wx) <= 1e-9 * size * hypot(ux, uy)
