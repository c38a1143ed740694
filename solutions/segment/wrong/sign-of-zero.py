"""sign-of-zero

The stable formula uses a sign that is 0 for b = 0, and both roots become 0 or a division by it.
Take the sign of 0 as +1 (or use copysign).
"""

from math import hypot, sqrt


def sign(x):
    return (x > 0) - (x < 0)


def circle_segment(cx, cy, r, A, B):
    fx, fy = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    near = 1e-10 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    a = dx * dx + dy * dy
    if a == 0:
        return [A] if abs(hypot(fx, fy) - r) <= near else []
    b = fx * dx + fy * dy
    c = fx * fx + fy * fy - r * r
    k = dx * fy - dy * fx
    gap = r - abs(k) / sqrt(a)
    if gap < -near:
        return []
    if gap <= near:
        ts = [-b / a]
    else:
        q = -b - sign(b) * sqrt(r * r * a - k * k)
        ts = sorted([q / a, c / q if q else 0.0])
    slack = near / sqrt(a)
    return [(A[0] + t * dx, A[1] + t * dy) for t in ts if -slack <= t <= 1 + slack]
