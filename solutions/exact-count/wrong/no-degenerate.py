"""no-degenerate

A == B makes the discriminant 0, which is taken for a tangency. There is no line then: return None
first.
"""


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    delta = r * r * (dx * dx + dy * dy) - k * k
    return (delta > 0) + (delta >= 0)
