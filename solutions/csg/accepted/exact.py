"""exact

Rational numbers throughout, roots to 60 digits; a solid is a set of whole numbers, those of its pieces.
"""

from fractions import Fraction
from math import isqrt

SNAP = Fraction(1, 10**12)


def square_root(value):
    """The root of a rational number from below, to about 60 digits."""
    shift = 400
    return Fraction(isqrt((value.numerator << 2 * shift) // value.denominator), 1 << shift)


def inside_spans(circles, O, D, program):
    ox, oy, dx, dy = map(Fraction, (*O, *D))
    scene = [tuple(map(Fraction, circle)) for circle in circles]
    slack = SNAP * max(max(r, abs(x - ox), abs(y - oy)) for x, y, r in scene)
    a, step = dx * dx + dy * dy, max(abs(dx), abs(dy))
    discs = []
    for x, y, r in scene:
        fx, fy = ox - x, oy - y
        square = (dx * fy - dy * fx) ** 2 / a
        if r <= slack or square >= (r - slack) ** 2:
            discs.append(None)
            continue
        middle, half = -(fx * dx + fy * dy) / a, square_root((r * r - square) / a)
        discs.append((max(Fraction(0), middle - half), max(Fraction(0), middle + half)))
    cuts = []
    for end in sorted(end for disc in discs if disc for end in disc):
        if not cuts or (end - cuts[-1]) * step > slack:
            cuts.append(end)

    def place(end):
        return max(at for at, cut in enumerate(cuts) if cut <= end)

    solids = []
    for number in program:
        if number >= 0:
            disc = discs[number]
            solids.append(set(range(place(disc[0]), place(disc[1]))) if disc else set())
            continue
        upper, lower = solids.pop(), solids.pop()
        solids.append(lower | upper if number == -1 else lower & upper if number == -2 else lower - upper)
    inside = solids.pop()
    starts = sorted(piece for piece in inside if piece - 1 not in inside)
    ends = sorted(piece + 1 for piece in inside if piece + 1 not in inside)
    return [(float(cuts[start]), float(cuts[end])) for start, end in zip(starts, ends)]
