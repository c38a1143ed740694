"""zero-radius

A circle of radius 0 is taken for no circle and gets 0. It is the point C: a line through C has one
point in common with it.
"""


def exact_count(cx, cy, r, A, B):
    if tuple(A) == tuple(B):
        return None
    if not r:
        return 0
    dx, dy = B[0] - A[0], B[1] - A[1]
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    delta = r * r * (dx * dx + dy * dy) - k * k
    return 2 if delta > 0 else 1 if delta == 0 else 0
