"""equality-tangency

A tangency is asked for with ==. Right in whole numbers, but once the figure has been turned by some
angle the rounded distance is never equal to the radius. Compare within a small fraction of the
extent.
"""


def line_count(cx, cy, r, A, B):
    dx = B[0] - A[0]
    dy = B[1] - A[1]
    a = dx * dx + dy * dy
    if a == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    delta = r * r * a - k * k
    if delta == 0:
        return 1
    if delta > 0:
        return 2
    return 0
