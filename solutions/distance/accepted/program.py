"""program

Reads the cases from standard input. The triangle's area comes from the shoelace formula, its corners seen from P.
"""

import sys
from math import dist


def number(token):
    return int(token) if token.lstrip("+-").isdigit() else float(token)


def main():
    lines = sys.stdin.read().splitlines()
    for line in lines[1 : int(lines[0]) + 1]:
        ax, ay, bx, by, px, py = map(number, line.split())
        base = dist((ax, ay), (bx, by))
        if not base:
            print("none")
            continue
        area = (ax - px) * (by - ay) - (ay - py) * (bx - ax)
        print(repr(abs(area) / base))


main()
