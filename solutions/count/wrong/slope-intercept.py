"""slope-intercept

The line is written as y = m·x + n, which a vertical line is not: the division by zero ends the
program, and steep lines lose their digits. Work with the direction B - A and the cross product.
"""

from math import sqrt


def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    m = (B[1] - A[1]) / (B[0] - A[0])
    n = (A[1] - cy) - m * (A[0] - cx)
    d = abs(n) / sqrt(m * m + 1)
    extent = max(r, abs(A[0] - cx), abs(A[1] - cy), abs(B[0] - cx), abs(B[1] - cy))
    if abs(d - r) < 1e-10 * extent:
        return 1
    return 2 if d < r else 0
