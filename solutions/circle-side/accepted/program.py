"""program

Reads the cases from standard input.
"""

import sys


def main():
    for _ in range(int(sys.stdin.readline())):
        cx, cy, r, px, py = map(int, sys.stdin.readline().split())
        gap = (px - cx) ** 2 + (py - cy) ** 2 - r**2
        print(1 if gap > 0 else -1 if gap < 0 else 0)


main()
