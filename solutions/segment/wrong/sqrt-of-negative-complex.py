"""sqrt-of-negative

A line that misses the circle is given complex points, or an error where they are compared. The root of a
negative number is complex with ** 0.5. Compare the distance with the radius first.
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
    half = ((r - d) * (r + d)) ** 0.5 if abs(d - r) > near else 0.0
    places = [foot - half, foot + half] if half else [foot]
    found = [s for s in places if -near <= s.real <= length + near]
    return [(A[0] + s * ux, A[1] + s * uy) for s in found]
