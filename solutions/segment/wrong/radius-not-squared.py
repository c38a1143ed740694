"""radius-not-squared

The equation is |P - C|² = r instead of r².
Square the radius.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    fx, fy = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    near = 1e-10 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    a = dx * dx + dy * dy
    if a == 0:
        return [A] if abs(hypot(fx, fy) - r) <= near else []
    b = fx * dx + fy * dy
    c = fx * fx + fy * fy - r
    disc = b * b - a * c
    if disc < 0:
        return []
    ts = sorted({(-b - sqrt(disc)) / a, (-b + sqrt(disc)) / a})
    slack = near / sqrt(a)
    return [(A[0] + t * dx, A[1] + t * dy) for t in ts if -slack <= t <= 1 + slack]
