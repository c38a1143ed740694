"""program

Reads the cases from standard input.
"""

import sys


def main():
    for _ in range(int(sys.stdin.readline())):
        ax, ay, bx, by, px, py = map(int, sys.stdin.readline().split())
        print(*((px, ay) if ay == by else (ax, py)))


main()
