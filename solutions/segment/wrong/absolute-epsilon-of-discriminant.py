"""absolute-epsilon

The discriminant, which is a fourth power of a length, is compared with 1e-9.
Compare lengths instead, the distance of the line with the radius, with a small part of the extent.
"""

from math import sqrt


def circle_segment(cx, cy, r, A, B):
    fx, fy = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    a = dx * dx + dy * dy
    c = fx * fx + fy * fy - r * r
    if a == 0:
        return [A] if abs(c) < 1e-9 else []
    b = fx * dx + fy * dy
    k = dx * fy - dy * fx
    disc = r * r * a - k * k
    if disc < -1e-9:
        return []
    if disc <= 1e-9:
        ts = [-b / a]
    else:
        root = sqrt(disc)
        ts = [(-b - root) / a, (-b + root) / a]
    return [(A[0] + t * dx, A[1] + t * dy) for t in ts if -1e-9 <= t <= 1 + 1e-9]
