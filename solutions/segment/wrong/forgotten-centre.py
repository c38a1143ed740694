"""forgotten-centre

The centre is moved to the origin, and the points are returned without moving them back.
Add C to what is returned.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay, bx, by = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    near = 1e-10 * max(r, abs(ax), abs(ay), abs(bx), abs(by))
    dx, dy = bx - ax, by - ay
    n = hypot(dx, dy)
    if n == 0:
        return [A] if abs(hypot(ax, ay) - r) <= near else []
    ux, uy = dx / n, dy / n
    d = abs(ux * ay - uy * ax)
    if d > r + near:
        return []
    h = sqrt((r - d) * (r + d)) if d < r - near else 0
    m = -(ux * ax + uy * ay)
    return [(ax + s * ux, ay + s * uy) for s in sorted({m - h, m + h}) if -near <= s <= n + near]
