"""cancellation

The textbook discriminant b² − 4ac in doubles: with A far away it is the small difference of two huge
numbers. Write it as r²·a − k² with the cross product k.
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
    dx, dy = bx - ax, by - ay
    a = dx * dx + dy * dy
    b = 2 * (float(ax) * dx + float(ay) * dy)
    c = float(ax) ** 2 + float(ay) ** 2 - r * r
    delta = b * b - 4 * a * c
    limit = 4 * a * near * (2 * r + near)
    if delta < -limit:
        return []
    half = sqrt(delta) / (2 * a) * length if delta > limit else 0.0
    foot = -b / (2 * a) * length
    places = [foot - half, foot + half] if half else [foot]
    return [(A[0] + s * ux, A[1] + s * uy) for s in places if -near <= s <= length + near]
