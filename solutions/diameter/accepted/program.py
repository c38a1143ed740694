"""program

Reads the cases from standard input.
"""

import sys


def main():
    for _ in range(int(sys.stdin.readline())):
        ax, ay, bx, by, px, py = map(int, sys.stdin.readline().split())
        dot = (ax - px) * (bx - px) + (ay - py) * (by - py)
        print(1 if dot > 0 else -1 if dot < 0 else 0)


main()
