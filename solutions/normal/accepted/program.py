"""program

A whole program: T on the first line, then a case a line; answers `x y` or `none`. The sign is that of the origin: it is
inside, on the circle or outside, and only from outside or on the way in does the ray enter.
"""

import sys
from math import sqrt


def normal(cx, cy, r, ox, oy, dx, dy):
    speed = sqrt(dx * dx + dy * dy)
    if r == 0 or speed == 0:
        return None
    ux, uy = dx / speed, dy / speed
    px, py = ox - cx, oy - cy
    eps = 1e-10 * max(r, abs(px), abs(py))
    side = ux * py - uy * px  # how far left of C the ray passes
    lead = -(ux * px + uy * py)
    if abs(side) > r + eps:
        return None
    if abs(side) >= r - eps:
        if lead < -eps:
            return None
        return (-uy, ux) if side > 0 else (uy, -ux)
    half = sqrt((r - side) * (r + side))
    if lead - half >= -eps:
        along, across = -half / r, side / r
    elif lead + half >= -eps:
        along, across = -half / r, -side / r
    else:
        return None
    return along * ux - across * uy, along * uy + across * ux


def main():
    lines = sys.stdin.read().splitlines()
    for line in lines[1 : 1 + int(lines[0])]:
        found = normal(*map(float, line.split()))
        print("none" if found is None else "%r %r" % found)


main()
