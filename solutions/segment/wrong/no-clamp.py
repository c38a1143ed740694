"""no-clamp

The points of the whole line are returned, also those before A and beyond B.
Keep a root only if 0 <= t <= 1, with a little slack.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    near = 1e-10 * max(r, abs(ax), abs(ay), abs(B[0] - cx), abs(B[1] - cy))
    n = hypot(dx, dy)
    if n == 0:
        return [A] if abs(hypot(ax, ay) - r) <= near else []
    ux, uy = dx / n, dy / n
    d = ux * ay - uy * ax
    s = -(ux * ax + uy * ay)
    fx, fy = A[0] + s * ux, A[1] + s * uy
    if abs(d) > r + near:
        return []
    if abs(d) >= r - near:
        return [(fx, fy)]
    h = sqrt(r * r - d * d)
    return [(fx - h * ux, fy - h * uy), (fx + h * ux, fy + h * uy)]
