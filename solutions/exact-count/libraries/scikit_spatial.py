"""scikit-spatial 10.0.0: Circle.intersect_line

Coordinates become doubles. It gives two points, equal ones for a tangent, and raises ValueError for a miss.
"""

from skspatial.objects import Circle, Line


def exact_count(cx, cy, r, A, B):
    if A == B:
        return None
    if r == 0:
        return int((B[0] - A[0]) * (cy - A[1]) == (B[1] - A[1]) * (cx - A[0]))
    try:
        found = Circle([float(cx), float(cy)], float(r)).intersect_line(
            Line.from_points([float(A[0]), float(A[1])], [float(B[0]), float(B[1])])
        )
    except ValueError:
        return 0
    return len(set(map(tuple, found)))
