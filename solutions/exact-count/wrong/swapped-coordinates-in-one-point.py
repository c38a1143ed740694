"""swapped-coordinates

A is read as (y, x), B as (x, y). Both are (x, y).
"""

def exact_count(cx, cy, r, A, B):
    if tuple(A) == tuple(B):
        return None
    A = A[1], A[0]
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return 0
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    reach = r * r * (dx * dx + dy * dy)
    if k * k == reach:
        return 1
    return 2 if k * k < reach else 0
