"""reversed-order

The stable formula gives the roots q/a and c/q as they come: where both are on the segment b is negative, and q/a
is the greater one. Sort them by t before returning.
"""

import math


def circle_segment(cx, cy, r, A, B):
    fx, fy = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    near = 1e-10 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    a = dx * dx + dy * dy
    if a == 0:
        return [A] if abs(math.hypot(fx, fy) - r) <= near else []
    b = fx * dx + fy * dy
    k = dx * fy - dy * fx
    gap = r - abs(k) / math.sqrt(a)
    if gap < -near:
        return []
    if gap <= near:
        ts = [-b / a]
    else:
        q = -b - math.copysign(math.sqrt(r * r * a - k * k), b)
        ts = [q / a, (fx * fx + fy * fy - r * r) / q]
    slack = near / math.sqrt(a)
    return [(A[0] + t * dx, A[1] + t * dy) for t in ts if -slack <= t <= 1 + slack]
