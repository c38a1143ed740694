"""tight-epsilon

The epsilon is 1e-14 of the extent, about what rounding does, and much less than what the statement calls touching.
Stay between the two bands of the promise: 1e-10 of the extent.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    near = 1e-14 * max(r, abs(ax), abs(ay), abs(B[0] - cx), abs(B[1] - cy))
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
