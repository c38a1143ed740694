"""sqrt-of-negative

Nothing keeps a line that misses the circle from the square root, which raises ValueError.
Compare the line's distance with the radius first.
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
    if abs(abs(k) / math.sqrt(a) - r) <= near:
        ts = [-b / a]
    else:
        root = math.sqrt(r * r * a - k * k)
        ts = [(-b - root) / a, (-b + root) / a]
    slack = near / math.sqrt(a)
    return [(A[0] + t * dx, A[1] + t * dy) for t in ts if -slack <= t <= 1 + slack]
