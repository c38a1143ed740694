"""program

A whole program. The common tangents meet on the line of centres, at a centre of homothety: its polar is the chord.
"""

import sys
from math import hypot, sqrt


def points(x1, y1, p, x2, y2, q):
    dx, dy = x2 - x1, y2 - y1
    d = hypot(dx, dy)
    eps = 1e-10 * max(p, q, d)
    for other in (-q, q):  # outer, then inner
        total = p + other  # what the tangents' meeting point is p·d/total away
        gap = d - abs(total)
        if gap < -eps:
            continue
        foot = p * (total / d)  # p² over that distance: the polar's foot
        if gap <= eps:
            foot = p if total > 0 else -p
            yield x1 + foot * dx / d, y1 + foot * dy / d
            continue
        half = p * (sqrt(gap * (d + abs(total))) / d)
        for h in (half, -half):
            yield x1 + (foot * dx - h * dy) / d, y1 + (foot * dy + h * dx) / d


def main():
    lines = sys.stdin.read().splitlines()
    for line in lines[1 : 1 + int(lines[0])]:
        found = list(points(*map(float, line.split())))
        print(len(found), *(repr(x) for point in found for x in point))


main()
