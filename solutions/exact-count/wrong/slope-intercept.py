"""slope-intercept

The line is written as y = m·x + n. With fractions that is exact, but a vertical line has no slope:
the division by zero ends the program. Work with the direction B - A.
"""

from fractions import Fraction


def exact_count(cx, cy, r, A, B):
    if A == B:
        return None
    m = Fraction(B[1] - A[1], B[0] - A[0])
    n = (A[1] - cy) - m * (A[0] - cx)
    d2 = n * n / (m * m + 1)
    if d2 == r * r:
        return 1
    return 2 if d2 < r * r else 0
