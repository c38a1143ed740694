"""program

Reads the cases from standard input. All is divided by the radius first, so that the sphere is the unit sphere.
"""

import sys
from math import hypot, sqrt


def meet(cx, cy, cz, r, ox, oy, oz, dx, dy, dz):
    speed = hypot(dx, dy, dz)
    if r == 0 or speed == 0:
        return None
    x, y, z = (ox - cx) / r, (oy - cy) / r, (oz - cz) / r
    room = 1e-10 * max(1.0, abs(x), abs(y), abs(z))
    u, v, w = dx / speed, dy / speed, dz / speed
    beside = hypot(v * z - w * y, w * x - u * z, u * y - v * x)
    if beside > 1 + room:
        return None
    half = sqrt((1 - beside) * (1 + beside)) if beside < 1 - room else 0.0
    middle = -(u * x + v * y + w * z)
    enters = middle - half >= -room
    way = middle - half if enters else middle + half
    if way < -room:
        return None
    side = 1 if enters else -1
    t = way * r / speed if way > room else 0.0
    return t, side * (x + way * u), side * (y + way * v), side * (z + way * w)


def main():
    lines = sys.stdin.read().splitlines()
    for line in lines[1 : int(lines[0]) + 1]:
        answer = meet(*map(float, line.split()))
        print("none" if answer is None else " ".join(map(repr, answer)))


main()
