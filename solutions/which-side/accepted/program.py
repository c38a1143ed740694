"""program

Reads the cases from standard input.
"""

import sys


def main():
    for _ in range(int(sys.stdin.readline())):
        ax, ay, bx, by, px, py = map(int, sys.stdin.readline().split())
        cross = (bx - ax) * (py - ay) - (by - ay) * (px - ax)
        print(1 if cross > 0 else -1 if cross < 0 else 0)


main()
