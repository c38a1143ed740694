"""program

Reads the cases from standard input.
"""

import sys


def main():
    for _ in range(int(sys.stdin.readline())):
        cx, cy, r, ax, ay, bx, by = map(int, sys.stdin.readline().split())
        k = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        gap = r * r * ((bx - ax) ** 2 + (by - ay) ** 2) - k * k
        print(2 if gap > 0 else 1 if gap == 0 else 0)


main()
