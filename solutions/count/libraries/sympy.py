"""sympy 1.14.0: Circle.intersection(Line)

Points are exact: Point makes a simple fraction of each float, by nsimplify, so 5.0000001 becomes 5.
"""

from math import hypot

from sympy import Circle, Line, Point


def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    if r == 0:
        return int(on_line(cx, cy, A, B))
    a, b = Point(*A), Point(*B)
    return len(Circle(Point(cx, cy), r).intersection(Line(a, b))) if a != b else None


def on_line(cx, cy, A, B):
    """Whether the point C, the circle of radius 0, is on the line."""
    ux, uy, wx, wy = B[0] - A[0], B[1] - A[1], cx - A[0], cy - A[1]
    size = max(map(abs, (wx, wy, cx - B[0], cy - B[1])))
    return abs(ux * wy - uy * wx) <= 1e-9 * size * hypot(ux, uy)
