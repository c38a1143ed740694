"""sqrt-of-negative

The root of the discriminant is taken before anybody has asked for its sign: every line that misses
the circle ends in a ValueError. Decide on the sign first, and only then take the root.
"""

import math


def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    dx, dy = B[0] - A[0], B[1] - A[1]
    fx, fy = A[0] - cx, A[1] - cy
    a = dx * dx + dy * dy
    b = 2 * (fx * dx + fy * dy)
    c = fx * fx + fy * fy - r * r
    root = math.sqrt(b * b - 4 * a * c)
    t1 = (-b - root) / (2 * a)
    t2 = (-b + root) / (2 * a)
    return 1 if abs(t1 - t2) < 1e-9 else 2
