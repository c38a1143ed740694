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


def all_hits(circles, O, D):
    ox, oy, dx, dy = map(Fraction, (*O, *D))
    scene = [tuple(map(Fraction, circle)) for circle in circles]
    slack = SNAP * max(max(r, abs(x - ox), abs(y - oy)) for x, y, r in scene)
    a, step = dx * dx + dy * dy, max(abs(dx), abs(dy))
    hits = []
    for index, (x, y, r) in enumerate(scene):
        fx, fy = ox - x, oy - y
        square = (dx * fy - dy * fx) ** 2 / a
        middle = -(fx * dx + fy * dy) / a
        if square > (r + slack) ** 2:
            continue
        if r <= slack or square >= (r - slack) ** 2:
            found = [(middle, "touch")]
        else:
            half = square_root((r * r - square) / a)
            found = [(middle - half, "enter"), (middle + half, "exit")]
        hits += [(max(t, Fraction(0)), index, tag) for t, tag in found if t * step >= -slack]
    return [(float(t), index, tag) for t, index, tag in sorted(hits)]
