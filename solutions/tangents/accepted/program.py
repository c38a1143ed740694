"""program

A whole program: T on the first line, then a case a line. It goes from P along the tangents, by their length.
"""

import sys
from math import hypot, sqrt


def touching(cx, cy, r, px, py):
    if r == 0:
        return [cx, cy]
    vx, vy = cx - px, cy - py  # from P to the centre
    d = hypot(vx, vy)
    if abs(d - r) <= 1e-10 * max(r, abs(vx), abs(vy)):
        return [px, py]
    if d < r:
        return []
    length = sqrt((d - r) * (d + r))
    cosine, sine = length / d, r / d
    vx, vy = vx / d * length, vy / d * length
    found = []
    for s in (sine, -sine):  # turned to the left, then to the right
        found += [px + cosine * vx - s * vy, py + s * vx + cosine * vy]
    return found


def main():
    lines = sys.stdin.read().splitlines()
    for line in lines[1 : 1 + int(lines[0])]:
        numbers = touching(*map(float, line.split()))
        print(len(numbers) // 2, *map(repr, numbers))


main()
