"""ezdxf 1.4.5: ConstructionCircle.intersect_ray

Two points where the distance is below r, one where it is r within 1e-10, or within a relative 1e-9.
"""

from math import hypot

from ezdxf.math import ConstructionCircle, ConstructionRay


def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    if r == 0:
        return int(on_line(cx, cy, A, B))
    return len(ConstructionCircle((cx, cy), r).intersect_ray(ConstructionRay(A, B)))


def on_line(cx, cy, A, B):
    """Whether the point C, the circle of radius 0, is on the line."""
    ux, uy, wx, wy = B[0] - A[0], B[1] - A[1], cx - A[0], cy - A[1]
    size = max(map(abs, (wx, wy, cx - B[0], cy - B[1])))
    return abs(ux * wy - uy * wx) <= 1e-9 * size * hypot(ux, uy)
