"""rhino3dm 8.35.0: Intersection.LineCircle

The line is infinite. It says None, Single or Multiple, and does not document what it takes for a touch.
"""

from math import hypot

from rhino3dm import Circle, Intersection, Line, Point3d


def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    if r == 0:
        return int(on_line(cx, cy, A, B))
    line = Line(Point3d(*A, 0), Point3d(*B, 0))
    found = Intersection.LineCircle(line, Circle(Point3d(cx, cy, 0), r))
    return int(found[0])


def on_line(cx, cy, A, B):
    """Whether the point C, the circle of radius 0, is on the line."""
    ux, uy, wx, wy = B[0] - A[0], B[1] - A[1], cx - A[0], cy - A[1]
    size = max(map(abs, (wx, wy, cx - B[0], cy - B[1])))
    return abs(ux * wy - uy * wx) <= 1e-9 * size * hypot(ux, uy)
