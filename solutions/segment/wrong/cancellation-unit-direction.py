"""cancellation

b² − c for a direction of length 1 is |f·u|² − |f|² + r²: two squares that are nearly equal when A is far
away. The cross product gives the distance of the line without a difference.
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
    foot = -(ux * ax + uy * ay)
    square = foot * foot - (ax * ax + ay * ay - r * r)
    if square < -near * (2 * r + near):
        return []
    half = sqrt(square) if square > near * (2 * r + near) else 0.0
    places = [foot - half, foot + half] if half else [foot]
    return [(A[0] + s * ux, A[1] + s * uy) for s in places if -near <= s <= length + near]
