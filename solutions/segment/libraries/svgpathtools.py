"""svgpathtools 1.8.0: Arc.intersect(Line), for the two halves of the circle

Its docstring says that intersections of arcs are "only half-heartedly implemented and not well tested".
"""

from math import hypot

from svgpathtools import Arc, Line


def circle_segment(cx, cy, r, A, B):
    if (known := at_a_point(cx, cy, r, A, B)) is not None:
        return known
    left, right = complex(cx - r, cy), complex(cx + r, cy)
    line = Line(complex(*A), complex(*B))
    halves = [Arc(left, complex(r, r), 0, 0, 1, right), Arc(right, complex(r, r), 0, 0, 1, left)]
    found = sorted({t for half in halves for _, t in half.intersect(line)})
    return [(line.point(t).real, line.point(t).imag) for t in found]


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
