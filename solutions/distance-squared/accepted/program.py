"""program

Reads the cases from standard input.
"""

import sys


def main():
    for _ in range(int(sys.stdin.readline())):
        px, py, qx, qy = map(int, sys.stdin.readline().split())
        print((px - qx) ** 2 + (py - qy) ** 2)


main()
