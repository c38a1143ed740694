"""equality-tangency

A tangency is where the discriminant == 0, which floats almost never are.
Call it a tangency when the line's distance and the radius differ by less than 1e-10 of the extent.
"""

import math


def circle_segment(cx, cy, r, A, B):
    fx, fy = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    near = 1e-10 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    a = dx**2 + dy**2
    if a == 0:
        return [A] if abs(math.hypot(fx, fy) - r) <= near else []
    b = fx * dx + fy * dy
    disc = r**2 * a - (dx * fy - dy * fx) ** 2
    if disc < 0:
        return []
    if disc == 0:
        ts = [-b / a]
    else:
        ts = [(-b - math.sqrt(disc)) / a, (-b + math.sqrt(disc)) / a]
    slack = near / math.sqrt(a)
    return [(A[0] + t * dx, A[1] + t * dy) for t in ts if -slack <= t <= 1 + slack]
