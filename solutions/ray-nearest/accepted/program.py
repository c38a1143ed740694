"""program

A whole program: T on the first line, then a case a line; answers `t` or `none`.
"""

import sys
from math import sqrt


def nearest(cx, cy, r, ox, oy, dx, dy):
    speed2 = dx * dx + dy * dy
    if speed2 == 0:
        return None
    px, py = ox - cx, oy - cy
    eps = max(r, abs(px), abs(py)) * 1e-10
    speed = sqrt(speed2)
    cross = (dx * py - dy * px) / speed
    lead = -(dx * px + dy * py) / speed
    if abs(cross) > r + eps:
        return None
    if abs(cross) < r - eps:
        half = sqrt((r - cross) * (r + cross))
        outer = lead - half if lead < 0 else lead + half
        other = (px * px + py * py - r * r) / outer
        lengths = sorted([outer, other])
    else:
        lengths = [lead]
    for s in lengths:
        if s >= -eps:
            return 0 if s <= eps else s / speed
    return None


data = sys.stdin.read().split()
case = [float(word) for word in data[1:]]
for i in range(int(data[0])):
    t = nearest(*case[7 * i : 7 * i + 7])
    print("none" if t is None else repr(t))
