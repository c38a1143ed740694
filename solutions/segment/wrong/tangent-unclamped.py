"""tangent-unclamped

Two roots are held against the segment's ends, but the one of a tangency is returned wherever it is.
Clamp every root in the same way, the double one too.
"""

import math


def circle_segment(cx, cy, r, A, B):
    x, y = A[0] - cx, A[1] - cy
    u, v = B[0] - A[0], B[1] - A[1]
    tiny = 1e-10 * max(r, abs(x), abs(y), abs(B[0] - cx), abs(B[1] - cy))
    a = u * u + v * v
    if a == 0:
        return [A] if abs(math.hypot(x, y) - r) <= tiny else []
    length = math.sqrt(a)
    gap = abs(u * y - v * x) / length - r
    t0 = -(x * u + y * v) / a
    if gap > tiny:
        return []
    if gap >= -tiny:
        return [(A[0] + t0 * u, A[1] + t0 * v)]
    dt = math.sqrt(-gap * (gap + 2 * r)) / length
    ts = [t0 - dt, t0 + dt]
    return [(A[0] + t * u, A[1] + t * v) for t in ts if -tiny / length <= t <= 1 + tiny / length]
