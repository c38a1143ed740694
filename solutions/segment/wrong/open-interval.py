"""open-interval

A root exactly at an end is dropped: 0 < t < 1 instead of 0 <= t <= 1.
The segment is closed: let the comparison include the ends, with a little slack outwards.
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
    d = abs(ux * ay - uy * ax)
    mid = -(ux * ax + uy * ay)
    if d > r + near:
        return []
    if d >= r - near:
        where = [mid]
    else:
        half = sqrt((r - d) * (r + d))
        where = [mid - half, mid + half]
    return [(A[0] + w * ux, A[1] + w * uy) for w in where if near < w < n - near]
