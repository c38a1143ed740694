"""fractions, the root last

A float is a fraction, so |D|² and the cross product A × D are fractions, too. Only the root of |D|² is rounded, 400 bits
below the point.
"""

from fractions import Fraction
from math import isqrt


def root(x):
    return Fraction(isqrt((x.numerator << 800) // x.denominator), 1 << 400)


def normal_form(A, B):
    ax, ay, bx, by = map(Fraction, (*A, *B))
    dx, dy = bx - ax, by - ay
    if dx == dy == 0:
        return None
    length = root(dx * dx + dy * dy)
    return float(-dy / length), float(dx / length), float((ax * dy - ay * dx) / length)
