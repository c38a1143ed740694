"""program-with-fractions

Reads the cases from standard input and computes Δ exactly, in Fractions.
"""

import sys
from fractions import Fraction
from math import inf, nextafter


def exactly(word):
    """The int, or the double that is written; its decimals are not all of it."""
    return Fraction(int(word)) if word.lstrip("-").isdigit() else Fraction(float(word))


def main():
    for line in sys.stdin.readlines()[1:]:
        if line.strip():
            cx, cy, r, ax, ay, bx, by = map(exactly, line.split())
            dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
            delta = r * r * (dx * dx + dy * dy) - (dx * fy - dy * fx) ** 2
            near = float(delta)
            # repr(near) is a decimal near the double, not the double itself
            exact = near == delta == Fraction(repr(near))
            low, high = (near, near) if exact else (nextafter(near, -inf), nextafter(near, inf))
            print(repr(low), repr(high))


main()
