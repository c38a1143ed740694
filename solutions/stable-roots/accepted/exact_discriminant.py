"""exact-discriminant-and-vieta

Δ is computed exactly, as a Fraction, and its root is rounded once; the root of the equation that adds is
taken, and the other one from the product c/a.

Why it keeps all digits: b and √Δ are added with one sign, so nothing is lost there. Each root is then three
roundings away from the exact one: that of √Δ, of the sum and of the quotient, half a unit each. For b = 0
either sign will do; Python's `>=` takes one of them.

Why Δ is exact: b² and a·c may agree in all the digits that doubles keep of them, and what they differ in
decides whether there are two roots, one or none. Numbers whose squares overflow are no matter for
Fractions; only the root goes back to a double, from a fraction that was scaled by an even power of two.
"""

from fractions import Fraction
from math import ldexp, sqrt


def root(x):
    """√x of a Fraction above 0, rounded nearly once: x is scaled into the doubles first."""
    half = (x.numerator.bit_length() - x.denominator.bit_length()) // 2
    near = x / 4**half if half >= 0 else x * 4**-half
    return ldexp(sqrt(near), half)


def quadratic_roots(a, b, c):
    if a == 0:
        if b == 0:
            return [] if c else None
        return [-c / (2 * b)]
    delta = Fraction(b) ** 2 - Fraction(a) * Fraction(c)
    if delta < 0:
        return []
    if delta == 0:
        return [-b / a]
    s = root(delta)
    q = -(b + s) if b >= 0 else s - b
    return sorted([q / a, c / q])
