"""unnormalised-distance

k² is compared with r² without the a that belongs to it. Compare k² with r²·a.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    if k * k == r * r:
        return 1
    return 2 if k * k < r * r else 0
