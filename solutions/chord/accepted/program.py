"""program

Reads the cases from standard input. Dividing by the direction turns the line level; there the chord is twice the
leg beside its height, by the angle at the centre: 2·r·sin of the angle whose cosine is height by radius.
"""

import sys
from math import acos, sin


def chord(cx, cy, r, ax, ay, bx, by):
    along = complex(bx - ax, by - ay)
    if not along:
        return "none"
    first, second = complex(ax - cx, ay - cy), complex(bx - cx, by - cy)
    height = abs((first * along.conjugate()).imag) / abs(along)
    room = 1e-10 * max(r, abs(first), abs(second))
    if height > r + room:
        return "none"
    if height >= r - room:
        return "0"
    return repr(2 * r * sin(acos(height / r)))


def main():
    data = sys.stdin.read().split()
    for i in range(int(data[0])):
        print(chord(*map(float, data[1 + 7 * i : 8 + 7 * i])))


main()
