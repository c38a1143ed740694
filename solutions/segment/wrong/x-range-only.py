"""x-range-only

Only the x of a point is held against the segment's ends, which says nothing where the segment is vertical.
Compare t with 0 and 1 (or both coordinates).
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
    d = ux * ay - uy * ax
    if abs(d) > r + near:
        return []
    h = sqrt((r - d) * (r + d)) if abs(d) < r - near else 0
    points = [(cx - d * uy + s * ux, cy + d * ux + s * uy) for s in sorted({-h, h})]
    left, right = min(A[0], B[0]), max(A[0], B[0])
    return [p for p in points if left - near <= p[0] <= right + near]
