"""program

A whole program: T on the first line, then a case a line, `cx cy r k x1 y1 …`; answers `k edge x y …`.
"""

import sys
from math import hypot, sqrt


def crossings(cx, cy, r, corners):
    near = 1e-10 * max([r] + [abs(x - cx) for x, _ in corners] + [abs(y - cy) for _, y in corners])
    found = []
    for i, (x, y) in enumerate(corners):
        ahead = corners[i + 1] if i + 1 < len(corners) else corners[0]
        wx, wy = ahead[0] - x, ahead[1] - y
        size = hypot(wx, wy)
        wx, wy = wx / size, wy / size
        to, beside = wx * (cx - x) + wy * (cy - y), abs(wx * (cy - y) - wy * (cx - x))
        if beside > r + near:
            continue
        back = [0.0]
        if beside < r - near:
            half = sqrt(r - beside) * sqrt(r + beside)
            back = [-half, half]
        for step in back:
            if -near <= to + step < size - near:
                found += [i, x + (to + step) * wx, y + (to + step) * wy]
    return found


def main():
    lines = sys.stdin.read().splitlines()
    for line in lines[1 : 1 + int(lines[0])]:
        cx, cy, r, _, *flat = map(float, line.split())
        found = crossings(cx, cy, r, list(zip(flat[::2], flat[1::2])))
        print(len(found) // 3, *map(repr, found))


main()
