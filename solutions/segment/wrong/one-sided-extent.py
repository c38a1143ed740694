"""one-sided-extent

The extent leaves out B. Where B alone is far away, the threshold is far too narrow.
Take the largest of r and both ends' coordinates from C.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    bx, by = B[0] - cx, B[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    length = hypot(dx, dy)
    extent = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    touch = 1e-10 * max(r, abs(ax), abs(ay))
    end = 1e-10 * max(r, abs(ax), abs(ay))
    if length == 0:
        return [A] if abs(hypot(ax, ay) - r) <= 1e-10 * extent else []
    ux, uy = dx / length, dy / length
    foot, side = -(ax * ux + ay * uy), ux * ay - uy * ax
    gap = r - abs(side)
    if gap < -touch:
        return []
    half = sqrt(gap * (r + abs(side))) if gap > touch else 0.0
    places = (-half, half) if half else (0.0,)
    return [(cx - uy * side + s * ux, cy + ux * side + s * uy) for s in places if -end <= foot + s <= length + end]
