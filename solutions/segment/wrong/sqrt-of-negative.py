"""sqrt-of-negative

The absolute value is taken under the root, "to be safe", so that a miss gets points as well.
A negative discriminant means that there is no common point: return before taking the root.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    near = 1e-10 * max(r, abs(ax), abs(ay), abs(B[0] - cx), abs(B[1] - cy))
    n = hypot(dx, dy)
    if n == 0:
        return [A] if abs(hypot(ax, ay) - r) <= near else []
    ux, uy = dx / n, dy / n
    d = abs(ux * ay - uy * ax)
    h = 0 if abs(d - r) <= near else sqrt(abs(r * r - d * d))
    m = -(ux * ax + uy * ay)
    return [(A[0] + s * ux, A[1] + s * uy) for s in sorted({m - h, m + h}) if -near <= s <= n + near]
