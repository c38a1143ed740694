"""program-with-whole-numbers

Reads the cases from standard input. The three numbers become ints over one power of two, which changes no
root, and √Δ is an integer root with 70 bits and more.
"""

import sys
from fractions import Fraction
from math import isqrt


def roots(a, b, c):
    scale = max(x.denominator for x in (a, b, c))
    a, b, c = (int(x * scale) for x in (a, b, c))
    if a == 0:
        if b == 0:
            return None if c == 0 else []
        return [-c / (2 * b)]
    delta = b * b - a * c
    if delta < 0:
        return []
    if delta == 0:
        return [-b / a]
    shift = max(0, 70 - delta.bit_length() // 2)
    s = isqrt(delta << 2 * shift)
    b, c = b << shift, c << shift
    q = -(b + s) if b >= 0 else s - b
    return sorted([q / (a << shift), c / q])


def exactly(word):
    """The int, or the double that is written; its decimals are not all of it."""
    return Fraction(int(word)) if word.lstrip("-").isdigit() else Fraction(float(word))


def main():
    for line in sys.stdin.readlines()[1:]:
        if line.strip():
            found = roots(*map(exactly, line.split()))
            print("none" if found is None else " ".join([str(len(found)), *map(repr, found)]))


main()
