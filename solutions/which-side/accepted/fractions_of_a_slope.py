"""slope-as-a-fraction

Where the line is not upright, its height at P's x is an exact fraction, and P is above it or below it. Above is left
if the line runs to the right. An upright line is a case of its own.
"""

from fractions import Fraction


def sign(x):
    return (x > 0) - (x < 0)


def which_side(A, B, P):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0:
        return sign(A[0] - P[0]) * sign(dy)
    height = A[1] + Fraction(dy, dx) * (P[0] - A[0])
    return sign(P[1] - height) * sign(dx)
