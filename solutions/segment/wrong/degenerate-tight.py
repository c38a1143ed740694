"""degenerate-tight

For A == B the point must be on the circle within 1e-14 of the extent, which is less than the band.
Take a slack well above it: 1e-10 of the extent.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    bx, by = B[0] - cx, B[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    length = hypot(dx, dy)
    extent = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    touch = 1e-10 * extent
    end = 1e-10 * extent
    if length == 0:
        return [A] if abs(hypot(ax, ay) - r) <= 1e-14 * extent else []
    ux, uy = dx / length, dy / length
    foot, side = -(ax * ux + ay * uy), ux * ay - uy * ax
    gap = r - abs(side)
    if gap < -touch:
        return []
    half = sqrt(gap * (r + abs(side))) if gap > touch else 0.0
    places = (-half, half) if half else (0.0,)
    return [(cx - uy * side + s * ux, cy + ux * side + s * uy) for s in places if -end <= foot + s <= length + end]
