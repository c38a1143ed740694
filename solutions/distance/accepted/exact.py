"""fractions, the root last

The square of the distance is a fraction, k² / |D|²; only its root is taken in doubles. The fraction is scaled
to the size of 1 before that, by a power of four.
"""

from fractions import Fraction
from math import ldexp, sqrt


def distance(A, B, P):
    ax, ay, bx, by, px, py = map(Fraction, (*A, *B, *P))
    dx, dy = bx - ax, by - ay
    base = dx * dx + dy * dy
    if base == 0:
        return None
    square = (dx * (ay - py) - dy * (ax - px)) ** 2 / base
    if square == 0:
        return 0.0
    half = (square.numerator.bit_length() - square.denominator.bit_length()) // 2
    return ldexp(sqrt(square / Fraction(4) ** half), half)
