"""scikit-spatial 10.0.0: Circle.intersect_line

It gives two points, equal ones for a tangent, and raises ValueError where the discriminant is below 0.
"""

from math import hypot

from skspatial.objects import Circle, Line


def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    if r == 0:
        return int(on_line(cx, cy, A, B))
    try:
        found = Circle([cx, cy], r).intersect_line(Line.from_points(A, B))
    except ValueError:
        return 0
    return len(set(map(tuple, found)))


def on_line(cx, cy, A, B):
    """Whether the point C, the circle of radius 0, is on the line."""
    ux, uy, wx, wy = B[0] - A[0], B[1] - A[1], cx - A[0], cy - A[1]
    size = max(map(abs, (wx, wy, cx - B[0], cy - B[1])))
    return abs(ux * wy - uy * wx) <= 1e-9 * size * hypot(ux, uy)
