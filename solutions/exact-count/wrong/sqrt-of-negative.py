"""sqrt-of-negative

The root of the discriminant is taken before its sign is known: a line that misses the circle ends
in a ValueError. Only the sign is needed, and no root at all.
"""

from math import isqrt


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if (dx, dy) == (0, 0):
        return None
    fx, fy = A[0] - cx, A[1] - cy
    a, b, c = dx * dx + dy * dy, fx * dx + fy * dy, fx * fx + fy * fy - r * r
    root = isqrt(b * b - a * c)
    return len({-b - root, -b + root})
