"""forgotten-centre

cx and cy are never used: the circle is taken to stand at the origin.
Subtract the centre from A and B first, and add it to the points again.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    (ax, ay), (bx, by) = A, B
    near = 1e-10 * max(r, abs(ax), abs(ay), abs(bx), abs(by))
    n = hypot(bx - ax, by - ay)
    if n == 0:
        return [A] if abs(hypot(ax, ay) - r) <= near else []
    ux, uy = (bx - ax) / n, (by - ay) / n
    d = abs(ux * ay - uy * ax)
    foot = -(ux * ax + uy * ay)
    if d > r + near:
        return []
    half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
    steps = [foot - half, foot + half] if half else [foot]
    return [(ax + s * ux, ay + s * uy) for s in steps if -near <= s <= n + near]
