"""zero-radius

For a radius of 0 None is returned, as if there were no circle. It is the point C: return it if it lies on
the segment; the general way does so by itself.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    if not r:
        return None
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
    return [(A[0] + s * ux, A[1] + s * uy) for s in places if -near <= s <= length + near]
