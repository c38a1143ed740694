"""clamp-to-ends

A root outside the segment is moved to the nearer end, and the end is returned as if it were on the circle.
Drop such a root: the end is not a common point.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    near = 1e-10 * max(r, abs(ax), abs(ay), abs(B[0] - cx), abs(B[1] - cy))
    n = hypot(dx, dy)
    if n == 0:
        return [A] if abs(hypot(ax, ay) - r) <= near else []
    d = abs(dx * ay - dy * ax) / n
    t = -(ax * dx + ay * dy) / (n * n)
    if d > r + near:
        return []
    half = 0 if d >= r - near else sqrt((r - d) * (r + d)) / n
    found = []
    for root in (t - half, t + half):
        root = min(1, max(0, root))
        point = (A[0] + root * dx, A[1] + root * dy)
        if point not in found:
            found.append(point)
    return found
