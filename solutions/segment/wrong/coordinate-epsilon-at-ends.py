"""coordinate-epsilon

The slack at the ends is a fraction of the largest coordinate, which far from the origin is wider than the
figure. Measure it in the extent.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    bx, by = B[0] - cx, B[1] - cy
    extent = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    touch, end = 1e-10 * extent, 1e-10 * max(map(abs, (*A, *B)))
    length = hypot(bx - ax, by - ay)
    if length == 0:
        return [A] if abs(hypot(ax, ay) - r) <= 1e-10 * extent else []
    ux, uy = (bx - ax) / length, (by - ay) / length
    d = abs(ux * ay - uy * ax)
    foot = -(ux * ax + uy * ay)
    if d > r + touch:
        return []
    half = sqrt((r - d) * (r + d)) if d < r - touch else 0.0
    places = [foot - half, foot + half] if half else [foot]
    return [(A[0] + s * ux, A[1] + s * uy) for s in places if -end <= s <= length + end]
