"""kept-between-calls

Points are kept in a dict whose key is the line alone, so that another circle gets those of the first one. Make all
arguments the key, or keep nothing.
"""

from math import hypot, sqrt

known = {}


def line_points(cx, cy, r, A, B):
    if (A, B) in known:
        return known[A, B]
    dx, dy, fx, fy = B[0] - A[0], B[1] - A[1], A[0] - cx, A[1] - cy
    n = hypot(dx, dy)
    if n == 0:
        return None
    near = 1e-10 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    ux, uy = dx / n, dy / n
    s = ux * fy - uy * fx
    h = sqrt((r - s) * (r + s)) if abs(s) < r - near else 0.0
    steps = [] if abs(s) > r + near else [-h, h] if h else [0.0]
    known[A, B] = [(cx - s * uy + step * ux, cy + s * ux + step * uy) for step in steps]
    return known[A, B]
