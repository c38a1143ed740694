"""centre-as-fractions

The centre and the square of the radius as exact fractions, and then the question of any circle.
"""

from fractions import Fraction


def diameter_side(A, B, P):
    mx, my = Fraction(A[0] + B[0], 2), Fraction(A[1] + B[1], 2)
    gap = (P[0] - mx) ** 2 + (P[1] - my) ** 2 - (A[0] - mx) ** 2 - (A[1] - my) ** 2
    return (gap > 0) - (gap < 0)
