"""float-arithmetic

r² − k²/a, whose division makes a float of it: 53 bits, so that near misses and tangents fall together, and
an OverflowError beyond 1e308. Compare r²·a with k², in ints.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    gap = r * r - k * k / (dx * dx + dy * dy)
    if gap == 0:
        return 1
    return 2 if gap > 0 else 0
