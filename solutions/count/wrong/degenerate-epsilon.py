"""degenerate-epsilon

Two points that are close together are taken for one. They are two exact points and make an exact
line: only A == B has none, so compare the coordinates themselves.
"""

from math import dist, isclose


def line_count(cx, cy, r, A, B):
    if isclose(A[0], B[0], rel_tol=1e-9) and isclose(A[1], B[1], rel_tol=1e-9):
        return None
    ax, ay = A[0] - cx, A[1] - cy
    ux, uy = B[0] - A[0], B[1] - A[1]
    d = abs(ux * ay - uy * ax) / dist(A, B)
    e = max(r, abs(ax), abs(ay), abs(B[0] - cx), abs(B[1] - cy))
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
