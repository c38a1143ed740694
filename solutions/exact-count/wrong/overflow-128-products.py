"""overflow-128

Only the last products are wrapped, to 128 bits as of C's __int128: r²·a and k² have more from coordinates
of about 1e9 on. No fixed width serves numbers of any size.
"""

def i128(n):
    n %= 2**128
    return n - 2**128 if n >= 2**127 else n


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    delta = i128(i128(r * r * (dx * dx + dy * dy)) - i128(k * k))
    return 1 + (delta > 0) - (delta < 0)
