"""floats-and-a-root

The distance of C from the line with a root and a division. For numbers up to 20 that is enough: where the line touches
the circle |B - A| is a whole number, and no other line comes nearer than a hundred-thousandth.
"""

from math import hypot


def crossings(cx, cy, r, A, B):
    k = (B[0] - A[0]) * (cy - A[1]) - (B[1] - A[1]) * (cx - A[0])
    d = abs(k) / hypot(B[0] - A[0], B[1] - A[1])
    if abs(d - r) < 1e-9:
        return 1
    return 2 if d < r else 0
