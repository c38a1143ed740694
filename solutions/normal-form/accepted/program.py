"""program

Reads the cases from standard input. The line through A and B is the cross product of (A, 1) and (B, 1), as seen
from the middle between them, so that no large products are subtracted; then all is divided by the length.
"""

import sys
from math import sqrt


def number(token):
    return int(token) if token.lstrip("+-").isdigit() else float(token)


def main():
    data = sys.stdin.read().split()
    for i in range(int(data[0])):
        ax, ay, bx, by = map(number, data[1 + 4 * i : 5 + 4 * i])
        p, q = ay - by, bx - ax
        if p == 0 and q == 0:
            print("none")
            continue
        length = sqrt(p * p + q * q)
        s = (p / length) * (ax + bx) + (q / length) * (ay + by)
        print(p / length, q / length, -s / 2)


main()
