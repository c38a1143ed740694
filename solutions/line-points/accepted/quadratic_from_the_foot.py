"""quadratic from the foot

The quadratic in t, with its origin slid along the line to the foot, in two steps; there b is next to nothing, and
the stable pair of roots q/a and c/q is used for what is left of it. The points are C plus what is seen from it.
"""

from math import copysign, sqrt


def line_points(cx, cy, r, A, B):
    if A[0] == B[0] and A[1] == B[1]:
        return None
    dx, dy = B[0] - A[0], B[1] - A[1]
    a = dx * dx + dy * dy
    px, py = A[0] - cx, A[1] - cy
    size = max(r, abs(px), abs(py), abs(B[0] - cx), abs(B[1] - cy))
    for _ in range(2):
        t = -(px * dx + py * dy) / a
        px, py = px + t * dx, py + t * dy
    b = px * dx + py * dy
    d = sqrt(px * px + py * py)
    if abs(d - r) <= 1e-10 * size:
        return [(cx + px, cy + py)]
    c = (d - r) * (d + r)
    if c > 0:
        return []
    q = -(b + copysign(sqrt(b * b - a * c), b))
    return [(cx + px + t * dx, cy + py + t * dy) for t in sorted((q / a, c / q))]
