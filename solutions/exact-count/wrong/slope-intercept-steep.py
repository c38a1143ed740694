"""slope-intercept

A vertical line is given a slope of a million instead of none. Work with the direction B − A.
"""

from fractions import Fraction


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    m = Fraction(dy, dx) if dx else Fraction(10**6)
    n = (A[1] - cy) - m * (A[0] - cx)
    if n * n == r * r * (m * m + 1):
        return 1
    return 2 if n * n < r * r * (m * m + 1) else 0
