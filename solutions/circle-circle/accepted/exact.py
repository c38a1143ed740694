"""fractions

A float is a fraction, so d² against (r1 + r2)² and (r1 − r2)² says without any rounding how the circles lie. Only the
points of a crossing take a square root.
"""

from fractions import Fraction
from math import isqrt


def root(x):
    return Fraction(isqrt((x.numerator << 800) // x.denominator), 1 << 400)


def circle_circle(cx1, cy1, r1, cx2, cy2, r2):
    x, y, p, q = Fraction(cx1), Fraction(cy1), Fraction(r1), Fraction(r2)
    vx, vy = Fraction(cx2) - x, Fraction(cy2) - y
    square = vx * vx + vy * vy
    if square == 0:
        return [] if p != q else None if p else [(cx1, cy1)]
    if square > (p + q) ** 2 or square < (p - q) ** 2:
        return []
    along = (square + p * p - q * q) / (2 * square)
    beside = root(p * p / square - along * along)
    found = [(float(x + along * vx - s * vy), float(y + along * vy + s * vx)) for s in (beside, -beside)]
    return found if beside else found[:1]
