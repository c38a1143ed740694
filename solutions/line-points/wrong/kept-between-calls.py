"""kept-between-calls

The list of points is a default argument, made once, and every call finds those of the calls before in it. Make a new
list in each call.
"""

from math import hypot, sqrt


def line_points(cx, cy, r, A, B, found=[]):
    dx, dy, fx, fy = B[0] - A[0], B[1] - A[1], A[0] - cx, A[1] - cy
    n = hypot(dx, dy)
    if n == 0:
        return None
    near = 1e-10 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    ux, uy = dx / n, dy / n
    s = ux * fy - uy * fx
    if abs(s) <= r + near:
        h = sqrt((r - s) * (r + s)) if abs(s) < r - near else 0
        for step in sorted({-h, h}):
            found.append((cx - s * uy + step * ux, cy + s * ux + step * uy))
    return found[-2:]
