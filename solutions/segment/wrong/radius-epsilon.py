"""radius-epsilon

The epsilon is a part of the radius, and beside a long segment a small circle's is less than the rounding.
Measure it by the whole figure: the largest of r and the coordinates of A and B seen from C.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    near = 1e-10 * r
    n = hypot(dx, dy)
    if n == 0:
        return [A] if abs(hypot(ax, ay) - r) <= near else []
    ux, uy = dx / n, dy / n
    d = abs(ux * ay - uy * ax)
    if d > r + near:
        return []
    h = sqrt((r - d) * (r + d)) if d < r - near else 0
    m = -(ux * ax + uy * ay)
    return [(A[0] + s * ux, A[1] + s * uy) for s in sorted({m - h, m + h}) if -near <= s <= n + near]
