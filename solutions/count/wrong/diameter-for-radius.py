"""diameter-for-radius

The third argument is halved, as if it were the diameter. It is the radius.
"""

from math import hypot


def line_count(cx, cy, d, A, B):
    radius = d / 2
    ux, uy = B[0] - A[0], B[1] - A[1]
    if ux == 0 and uy == 0:
        return None
    vx, vy = A[0] - cx, A[1] - cy
    distance = abs(ux * vy - uy * vx) / hypot(ux, uy)
    limit = 1e-10 * max(radius, abs(vx), abs(vy), abs(B[0] - cx), abs(B[1] - cy))
    if abs(distance - radius) <= limit:
        return 1
    return 2 if distance < radius else 0
