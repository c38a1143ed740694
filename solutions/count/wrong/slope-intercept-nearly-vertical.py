"""slope-intercept

The line is written as y = m·x + n unless it is vertical, and a line counts as vertical if its x
changes by less than 1e-9 of the size. But A and B may be close together and their line still be any,
and a line that is nearly upright is elsewhere, far from A. Work with the direction B - A and the cross
product, which know no special case.
"""

from math import sqrt


def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    ax, ay = A[0] - cx, A[1] - cy
    size = max(r, abs(ax), abs(ay), abs(B[0] - cx), abs(B[1] - cy))
    if abs(B[0] - A[0]) < 1e-9 * size:
        d = abs(ax)
    else:
        m = (B[1] - A[1]) / (B[0] - A[0])
        d = abs(ay - m * ax) / sqrt(m * m + 1)
    if abs(d - r) < 1e-10 * size:
        return 1
    return 2 if d < r else 0
