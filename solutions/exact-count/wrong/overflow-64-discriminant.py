"""overflow-64

b² − a·c in 64-bit integers, as in C++ or Java: the products wrap around from coordinates of about 1e4 on.
Python's ints do not; elsewhere use a type wide enough for the fourth power of a coordinate.
"""

def wrapped(n):
    return (n + 2**63) % 2**64 - 2**63


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = wrapped(A[0] - cx), wrapped(A[1] - cy)
    dx, dy = wrapped(dx), wrapped(dy)
    a = wrapped(dx * dx + dy * dy)
    b = wrapped(fx * dx + fy * dy)
    c = wrapped(fx * fx + fy * fy - r * r)
    delta = wrapped(b * b - a * c)
    if delta == 0:
        return 1
    return 2 if delta > 0 else 0
