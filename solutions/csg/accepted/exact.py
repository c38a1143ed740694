"""fractions

Rational numbers throughout, roots 400 bits below the point: ends at one place are equal there but for that. A solid is
a set of whole numbers, those of its pieces.
"""

from fractions import Fraction
from math import isqrt

SAME = Fraction(1, 1 << 350)


def root(x):
    return Fraction(isqrt((x.numerator << 800) // x.denominator), 1 << 400)


def inside_spans(circles, O, D, program):
    ox, oy, dx, dy = map(Fraction, (*O, *D))
    a = dx * dx + dy * dy
    discs = []
    for circle in circles:
        x, y, r = map(Fraction, circle)
        fx, fy = ox - x, oy - y
        b, k = fx * dx + fy * dy, dx * fy - dy * fx
        half = root(max(Fraction(0), r * r * a - k * k))
        discs.append([max(Fraction(0), (-b - half) / a), max(Fraction(0), (-b + half) / a)])
    cuts = []
    for end in sorted(end for disc in discs for end in disc):
        if not cuts or end - cuts[-1] > SAME * end:
            cuts.append(end)

    def place(end):
        return max(at for at, cut in enumerate(cuts) if cut <= end)

    solids = []
    for number in program:
        if number >= 0:
            solids.append(set(range(*map(place, discs[number]))))
            continue
        upper, lower = solids.pop(), solids.pop()
        solids.append(lower | upper if number == -1 else lower & upper if number == -2 else lower - upper)
    inside = solids.pop()
    starts = sorted(piece for piece in inside if piece - 1 not in inside)
    ends = sorted(piece + 1 for piece in inside if piece + 1 not in inside)
    return [(float(cuts[start]), float(cuts[end])) for start, end in zip(starts, ends)]
