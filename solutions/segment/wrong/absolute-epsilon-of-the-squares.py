"""absolute-epsilon

d² and r² are compared within a fixed 1e-9, which is an area. Compare lengths, and with a small part of the
extent.
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
    square = (ux * ay - uy * ax) ** 2
    foot = -(ux * ax + uy * ay)
    if square > r * r + 1e-9:
        return []
    half = sqrt(r * r - square) if square < r * r - 1e-9 else 0.0
    places = [foot - half, foot + half] if half else [foot]
    return [(A[0] + s * ux, A[1] + s * uy) for s in places if -near <= s <= length + near]
