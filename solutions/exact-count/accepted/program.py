"""program-with-integer-roots

Reads the cases from standard input. The cross product is compared with the integer root of r²·a,
and with that root's square where they agree.
"""

import sys
from math import isqrt


def answer(cx, cy, r, ax, ay, bx, by):
    if ax == bx and ay == by:
        return "none"
    k = abs((bx - ax) * (ay - cy) - (by - ay) * (ax - cx))
    reach = r * r * ((bx - ax) ** 2 + (by - ay) ** 2)
    root = isqrt(reach)
    if k > root:
        return "0"
    if k < root or root * root < reach:
        return "2"
    return "1"


def main():
    cases = int(sys.stdin.readline())
    for _ in range(cases):
        print(answer(*map(int, sys.stdin.readline().split())))


main()
