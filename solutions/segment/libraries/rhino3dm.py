"""rhino3dm 8.35.0: Intersection.LineCircle

The line is infinite; its parameters run from 0 at A to 1 at B, and those outside are left out here.
"""

from math import hypot

from rhino3dm import Circle, Intersection, Line, Point3d


def circle_segment(cx, cy, r, A, B):
    if (known := at_a_point(cx, cy, r, A, B)) is not None:
        return known
    line = Line(Point3d(*A, 0), Point3d(*B, 0))
    kind, t1, p1, t2, p2 = Intersection.LineCircle(line, Circle(Point3d(cx, cy, 0), r))
    found = [(t1, p1), (t2, p2)][: int(kind)]
    return [(p.X, p.Y) for t, p in sorted(found, key=lambda each: each[0]) if 0 <= t <= 1]


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
