"""sentinel-degenerate

A == B is answered with -1 instead of None. The contract asks for None where there is no line.
"""


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    a = dx**2 + dy**2
    if a == 0:
        return -1
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    if k**2 == r**2 * a:
        return 1
    return 2 if k**2 < r**2 * a else 0
