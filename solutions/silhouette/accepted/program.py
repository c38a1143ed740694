"""program

Reads the cases from standard input. In each frame d/r − 1 is compared with h, wherever there is a radius.
"""

import sys
from math import hypot


def main():
    tokens = iter(sys.stdin.read().split())
    for _ in range(int(next(tokens))):
        count = int(next(tokens))
        numbers = [float(next(tokens)) for _ in range(3 * count + 5)]
        *flat, ox, oy, dx, dy, h = numbers
        size = hypot(dx, dy)
        shown = []
        for x, y, r in zip(flat[::3], flat[1::3], flat[2::3]):
            gx, gy = x - ox, y - oy
            over = abs(dx / size * gy - dy / size * gx) - r
            least = 1e-10 * max(r, abs(gx), abs(gy))
            if not shown:
                shown.append(int(over < 0))
            elif over > r * h + least:
                shown.append(0)
            elif over < -r * h - least:
                shown.append(1)
            else:
                shown.append(shown[-1])
        print(count, *shown)


main()
