"""slope-intercept

The line is written as y = m·x + n, and an upright one is tilted by 1e-12 so that it has a slope. For a figure of
1e-20 that is level. Work with the direction B - A and the cross product, which know no special case.
"""

from math import sqrt


def chord_length(cx, cy, r, A, B):
    if tuple(A) == tuple(B):
        return None
    ax, ay = A[0] - cx, A[1] - cy
    near = 1e-10 * max(r, abs(ax), abs(ay), abs(B[0] - cx), abs(B[1] - cy))
    dx, dy = B[0] - A[0], B[1] - A[1]
    m = dy / (dx or 1e-12)
    n = ay - m * ax
    d = abs(n) / sqrt(1 + m * m) if abs(m) < 1e150 else abs(ax)
    if d > r + near:
        return None
    return 0 if d >= r - near else 2 * sqrt((r - d) * (r + d))
