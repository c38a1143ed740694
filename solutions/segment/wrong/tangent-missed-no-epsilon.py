"""tangent-missed

d < r makes two points, and all else is a miss: a tangent gets none, or two where it was rounded to the
inside. Treat the tangency as a case of its own, within a small part of the extent.
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
    if d >= r:
        return []
    half = sqrt((r - d) * (r + d))
    places = [foot - half, foot + half]
    return [(A[0] + s * ux, A[1] + s * uy) for s in places if -near <= s <= length + near]
