"""equality-tangency

The foot of the perpendicular is computed, and its distance from the centre compared with the radius by ==.
After so many roundings it is hardly ever the same double. Compare within 1e-10 of the extent.
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
    d = hypot(ax + foot * ux, ay + foot * uy)
    if d > r:
        return []
    half = sqrt((r - d) * (r + d))
    places = [foot - half, foot + half] if d != r else [foot]
    return [(A[0] + s * ux, A[1] + s * uy) for s in places if -near <= s <= length + near]
