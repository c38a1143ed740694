"""kept-between-calls

√Δ is remembered by a and b, and the next c gets that of the one before. Remember nothing, or by all arguments.
"""

from fractions import Fraction
from math import sqrt

known = {}


def quadratic_roots(a, b, c):
    if a == 0:
        return ([] if c else None) if b == 0 else [-c / (2 * b)]
    if (a, b) not in known:
        known[a, b] = Fraction(b) ** 2 - Fraction(a) * Fraction(c)
    delta = known[a, b]
    if delta <= 0:
        return [] if delta else [-b / a]
    s = sqrt(delta)
    q = -(b + s) if b >= 0 else s - b
    return sorted([q / a, c / q])
