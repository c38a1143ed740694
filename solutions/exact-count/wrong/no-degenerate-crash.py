"""no-degenerate

The squared distance is a fraction whose denominator is 0 where A == B: a division by zero. There is no line
then; return None first.
"""

from fractions import Fraction


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    square = Fraction(k * k, dx * dx + dy * dy)
    if square == r * r:
        return 1
    return 2 if square < r * r else 0
