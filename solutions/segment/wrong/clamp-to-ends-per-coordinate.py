"""clamp-to-ends

The points are clamped to the box of the segment, coordinate by coordinate, and returned. Drop a point that
is not on the segment.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    bx, by = B[0] - cx, B[1] - cy
    near = 1e-10 * max(r, abs(ax), abs(ay), abs(bx), abs(by))
    length = hypot(bx - ax, by - ay)
    if length == 0:
        return [A] if abs(hypot(ax, ay) - r) <= near else []
    ux, uy = (bx - ax) / length, (by - ay) / length
    d = abs(ux * ay - uy * ax)
    foot = -(ux * ax + uy * ay)
    if d > r + near:
        return []
    half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
    places = [foot - half, foot + half] if half else [foot]
    left, right = sorted((A[0], B[0]))
    low, high = sorted((A[1], B[1]))
    found = [(A[0] + s * ux, A[1] + s * uy) for s in places]
    return [(min(right, max(left, x)), min(high, max(low, y))) for x, y in found]
