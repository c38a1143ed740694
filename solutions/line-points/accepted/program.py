"""program

Reads the cases from standard input. The points are where the circle is cut at the angles φ ± acos(d/r) about its
centre, φ being the direction of the perpendicular onto the line.
"""

import sys
from math import acos, atan2, cos, hypot, sin


def meet(cx, cy, r, ax, ay, bx, by):
    dx, dy = bx - ax, by - ay
    length = hypot(dx, dy)
    if not length:
        return None
    fx, fy = ax - cx, ay - cy
    side = (dx * fy - dy * fx) / length
    room = 1e-10 * max(r, abs(fx), abs(fy), abs(bx - cx), abs(by - cy))
    if abs(side) > r + room:
        return []
    left = atan2(dx, -dy)  # the normal on the left of the line
    if abs(side) >= r - room:
        return [(cx + side * cos(left), cy + side * sin(left))]
    turn = acos(side / r)
    return [(cx + r * cos(angle), cy + r * sin(angle)) for angle in (left + turn, left - turn)]


def main():
    lines = sys.stdin.read().splitlines()
    for line in lines[1 : int(lines[0]) + 1]:
        points = meet(*map(float, line.split()))
        if points is None:
            print("none")
        else:
            print(len(points), *(value for point in points for value in point))


main()
