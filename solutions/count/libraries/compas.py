"""compas 2.15.1: intersection_sphere_line, in the plane z = 0

One point where the discriminant is exactly 0, two above it, None below it.
"""

from math import hypot

from compas.geometry import intersection_sphere_line


def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    if r == 0:
        return int(on_line(cx, cy, A, B))
    found = intersection_sphere_line(((cx, cy, 0.0), r), ((*A, 0.0), (*B, 0.0)))
    return 0 if found is None else 2 if isinstance(found[0], tuple) else 1


def on_line(cx, cy, A, B):
    """Whether the point C, the circle of radius 0, is on the line."""
    ux, uy, wx, wy = B[0] - A[0], B[1] - A[1], cx - A[0], cy - A[1]
    size = max(map(abs, (wx, wy, cx - B[0], cy - B[1])))
    return abs(ux * wy - uy * wx) <= 1e-9 * size * hypot(ux, uy)
