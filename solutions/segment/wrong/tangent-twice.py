"""tangent-twice

A tangency comes out as two equal points.
Return the foot of the perpendicular once when the two roots are one.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    eps = 1e-10 * max(r, abs(ax), abs(ay), abs(B[0] - cx), abs(B[1] - cy))
    L = hypot(dx, dy)
    if L == 0:
        return [A] if abs(hypot(ax, ay) - r) <= eps else []
    dx, dy = dx / L, dy / L
    d = abs(dx * ay - dy * ax)
    if d > r + eps:
        return []
    h = sqrt((r - d) * (r + d)) if d < r - eps else 0.0
    m = -(ax * dx + ay * dy)
    return [(A[0] + s * dx, A[1] + s * dy) for s in (m - h, m + h) if -eps <= s <= L + eps]
