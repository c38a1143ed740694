"""program

Reads the cases from standard input. Everything is a fraction, and exact until it is printed.
"""

import sys
from fractions import Fraction


def main():
    lines = sys.stdin.read().splitlines()
    for line in lines[1 : int(lines[0]) + 1]:
        ax, ay, bx, by, cx, cy = (Fraction(float(token)) for token in line.split())
        dx, dy = bx - ax, by - ay
        if not dx and not dy:
            print("none")
            continue
        t = ((cx - ax) * dx + (cy - ay) * dy) / (dx**2 + dy**2)
        print(*map(float, (t, ax + t * dx, ay + t * dy)))


main()
