"""overflow-128

The arithmetic of 128-bit integers, as of C's __int128: the products wrap around from coordinates of
about 1e9 on. No fixed width serves numbers of any size.
"""

HALF = 1 << 127


def i128(n):
    return ((n + HALF) & (2 * HALF - 1)) - HALF


def exact_count(cx, cy, r, A, B):
    if tuple(A) == tuple(B):
        return None
    dx, dy = i128(B[0] - A[0]), i128(B[1] - A[1])
    fx, fy = i128(A[0] - cx), i128(A[1] - cy)
    b = i128(fx * dx + fy * dy)
    a = i128(dx * dx + dy * dy)
    c = i128(fx * fx + fy * fy - r * r)
    delta = i128(b * b - a * c)
    if delta == 0:
        return 1
    return 2 if delta > 0 else 0
