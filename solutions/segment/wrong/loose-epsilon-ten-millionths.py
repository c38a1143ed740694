"""loose-epsilon

A line within 3e-7 of the extent of a tangent is called one, a little wider than the promise: some near hits
and misses become tangents. Stay well below the promise's wider band: 1e-10.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    bx, by = B[0] - cx, B[1] - cy
    extent = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    touch, end = 3e-7 * extent, 1e-10 * extent
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
