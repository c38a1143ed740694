"""ezdxf 1.4.5: ConstructionCircle.intersect_line

Of the points of the infinite line it keeps those in the box around the segment, without any room.
"""

from math import hypot

from ezdxf.math import ConstructionCircle, ConstructionLine


def circle_segment(cx, cy, r, A, B):
    if (known := at_a_point(cx, cy, r, A, B)) is not None:
        return known
    found = ConstructionCircle((cx, cy), r).intersect_line(ConstructionLine(A, B))
    return sorted(((p.x, p.y) for p in found), key=lambda p: hypot(p[0] - A[0], p[1] - A[1]))


def at_a_point(cx, cy, r, A, B):
    """The answer where the circle or the segment is one point; None where neither is."""
    if A == B:
        far = hypot(A[0] - cx, A[1] - cy)
        return [A] if abs(far - r) <= 1e-9 * max(far, r) else []
    if r == 0:
        ux, uy = B[0] - A[0], B[1] - A[1]
        t = ((cx - A[0]) * ux + (cy - A[1]) * uy) / (ux * ux + uy * uy)
        x, y = A[0] + t * ux, A[1] + t * uy
        return [(cx, cy)] if 0 <= t <= 1 and hypot(cx - x, cy - y) <= 1e-9 * hypot(ux, uy) else []
    return None
