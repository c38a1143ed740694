"""floor-division

The squared distance is k² // a, which drops the fraction: a miss by less than one is a tangent. Compare k²
with r²·a instead, and divide by nothing.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    square = k * k // (dx * dx + dy * dy)
    if square == r * r:
        return 1
    return 2 if square < r * r else 0
