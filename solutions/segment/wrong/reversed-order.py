"""reversed-order

The points come in order from B to A.
Let the lesser t come first.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    bx, by = B[0] - cx, B[1] - cy
    dx, dy = A[0] - B[0], A[1] - B[1]
    near = 1e-10 * max(r, abs(bx), abs(by), abs(A[0] - cx), abs(A[1] - cy))
    n = hypot(dx, dy)
    if n == 0:
        return [B] if abs(hypot(bx, by) - r) <= near else []
    ux, uy = dx / n, dy / n
    d = abs(ux * by - uy * bx)
    if d > r + near:
        return []
    h = sqrt((r - d) * (r + d)) if d < r - near else 0
    m = -(ux * bx + uy * by)
    return [(B[0] + s * ux, B[1] + s * uy) for s in sorted({m - h, m + h}) if -near <= s <= n + near]
