"""exact

Rational numbers throughout; roots are taken to 60 digits by the integer root.
"""

from fractions import Fraction
from math import isqrt

SNAP = Fraction(1, 10**12)


def square_root(value):
    """The root of a rational number from below, to about 60 digits."""
    shift = 400
    return Fraction(isqrt((value.numerator << 2 * shift) // value.denominator), 1 << shift)


def side(square, radius, slack):
    """-1, 0 or 1 as the root of `square` is below the radius, within the slack of it or above."""
    if square > (radius + slack) ** 2:
        return 1
    return -1 if radius > slack and square < (radius - slack) ** 2 else 0


def circle_circle(cx1, cy1, r1, cx2, cy2, r2):
    x, y, p, q = Fraction(cx1), Fraction(cy1), Fraction(r1), Fraction(r2)
    vx, vy = Fraction(cx2) - x, Fraction(cy2) - y
    slack = SNAP * max(p, q, abs(vx), abs(vy))
    square = vx * vx + vy * vy
    if square <= slack * slack:
        if p == q == 0:
            return [(float(x), float(y))]
        return None if abs(p - q) <= slack else []
    outer, inner = side(square, p + q, slack), side(square, abs(p - q), slack)
    if outer > 0 or inner < 0:
        return []
    if outer == 0 or inner == 0:
        share = p / square_root(square) * (1 if outer == 0 or p > q else -1)
        return [(float(x + share * vx), float(y + share * vy))]
    along = (square + p * p - q * q) / (2 * square)
    beside = square_root(p * p / square - along * along)
    return [(float(x + along * vx - s * vy), float(y + along * vy + s * vx)) for s in (beside, -beside)]
