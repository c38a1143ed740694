"""program

A whole program: T on the first line, then a case a line. One routine serves both rays, with a least and a most distance.
"""

import sys
from math import hypot, sqrt


def nearest(circles, px, py, ux, uy, least, most):
    best = most, None
    for x, y, r in circles:
        along, aside = (x - px) * ux + (y - py) * uy, (x - px) * uy - (y - py) * ux
        if abs(aside) < r:
            half = sqrt((r - aside) * (r + aside))
            for s in (along - half, along + half):
                if least < s < best[0]:
                    best = s, (x, y)
    return best


def answer(tokens):
    n = int(tokens[0])
    values = list(map(float, tokens[1:]))
    ox, oy, dx, dy, lx, ly = values[3 * n :]
    circles = [(values[i] - ox, values[i + 1] - oy, values[i + 2]) for i in range(0, 3 * n, 3)]
    lx, ly = lx - ox, ly - oy
    e = max(abs(lx), abs(ly), *(max(abs(x), abs(y), r) for x, y, r in circles))
    size = hypot(dx, dy)
    ux, uy = dx / size, dy / size
    s, centre = nearest(circles, 0.0, 0.0, ux, uy, 0.0, float("inf"))
    if centre is None:
        return "none"
    px, py = s * ux, s * uy
    nx, ny = px - centre[0], py - centre[1]
    if (ux * nx + uy * ny) * ((lx - px) * nx + (ly - py) * ny) > 0:
        return "dark"
    way = hypot(lx - px, ly - py)
    _, blocker = nearest(circles, px, py, (lx - px) / way, (ly - py) / way, 1e-8 * e, way)
    return "dark" if blocker else "lit"


def main():
    lines = sys.stdin.read().splitlines()
    print("\n".join(answer(line.split()) for line in lines[1 : 1 + int(lines[0])]))


main()
