"""overflow-64

The arithmetic of 64-bit integers, as in C++ or Java: the products wrap around from coordinates of
about 1e5 on. Python's ints do not; elsewhere use a type wide enough for the fourth power of a
coordinate.
"""


def wrapped(n):
    return (n + 2**63) % 2**64 - 2**63


def exact_count(cx, cy, r, A, B):
    dx, dy = wrapped(B[0] - A[0]), wrapped(B[1] - A[1])
    if A[0] == B[0] and A[1] == B[1]:
        return None
    fx, fy = wrapped(A[0] - cx), wrapped(A[1] - cy)
    a = wrapped(dx * dx + dy * dy)
    k = wrapped(dx * fy - dy * fx)
    delta = wrapped(wrapped(wrapped(r * r) * a) - wrapped(k * k))
    return 1 + (delta > 0) - (delta < 0)
