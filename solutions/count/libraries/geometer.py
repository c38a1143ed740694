"""geometer 0.4.2: Circle.intersect(Line)

A circle is a conic over the complex numbers. Its points are compared within 1e-8; those of a miss are complex.
"""

from math import hypot

from geometer import Circle, Line, Point


def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    if r == 0:
        return int(on_line(cx, cy, A, B))
    found = Circle(Point(cx, cy), r).intersect(Line(Point(*A), Point(*B)))
    return sum(bool(each.isreal) for each in found)


def on_line(cx, cy, A, B):
    """Whether the point C, the circle of radius 0, is on the line."""
    ux, uy, wx, wy = B[0] - A[0], B[1] - A[1], cx - A[0], cy - A[1]
    size = max(map(abs, (wx, wy, cx - B[0], cy - B[1])))
    return abs(ux * wy - uy * wx) <= 1e-9 * size * hypot(ux, uy)
