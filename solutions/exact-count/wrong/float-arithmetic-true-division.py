"""float-arithmetic

k² is divided by a with /, which makes a float of it, with 53 bits. Compare k² with r²·a, in ints.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    try:
        square = k * k / (dx * dx + dy * dy)
    except OverflowError:
        square = float("inf")
    if square == r * r:
        return 1
    return 2 if square < r * r else 0
