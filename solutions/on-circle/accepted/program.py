"""program

Reads the cases from standard input. P is projected onto the circle, and how far that moves it decides.
"""

import sys


def side(cx, cy, r, px, py):
    f = complex(px - cx, py - cy)
    away = abs(f)
    nearest = f / away * r if away else complex(r, 0)
    moved = abs(f - nearest)
    if moved <= 1e-9 * max(r, away):
        return 0
    return 1 if away > r else -1


def main():
    lines = iter(sys.stdin)
    for _ in range(int(next(lines))):
        print(side(*map(float, next(lines).split())))


main()
