"""cancellation

The distance of the line is the root of |a|²·|b|² − (a·b)², by |D|: two numbers that are nearly equal when C
is near the line. The cross product gives it without a difference of large squares.
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
    dot = float(ax) * bx + float(ay) * by
    d = sqrt(max(0.0, (float(ax) ** 2 + float(ay) ** 2) * (float(bx) ** 2 + float(by) ** 2) - dot * dot)) / length
    foot = -(ux * ax + uy * ay)
    if d > r + near:
        return []
    half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
    places = [foot - half, foot + half] if half else [foot]
    return [(A[0] + s * ux, A[1] + s * uy) for s in places if -near <= s <= length + near]
