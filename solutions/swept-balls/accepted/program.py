"""program

A whole program: T on the first line, then a case a line; answers `t` or `none`.
"""

import sys
from math import hypot, sqrt


def meeting(ax, ay, bx, by, r, cx, cy, gx, gy, s):
    total = r + s
    eps = max(total, *(abs(z) for z in (bx - ax, by - ay, cx - ax, cy - ay, gx - ax, gy - ay))) * 1e-10
    ux, uy = cx - ax, cy - ay  # from the first to the second
    start = hypot(ux, uy)
    if start <= total + eps:
        return 0
    wx, wy = (bx - ax) - (gx - cx), (by - ay) - (gy - cy)
    speed = hypot(wx, wy)
    if speed == 0:
        return None
    lead, cross = (ux * wx + uy * wy) / speed, abs(ux * wy - uy * wx) / speed
    if lead < 0 or cross > total + eps:
        return None
    if cross < total - eps:
        lead = (start - total) * (start + total) / (lead + sqrt((total - cross) * (total + cross)))
    return lead / speed if lead <= speed + eps else None


data = sys.stdin.read().split()
case = [float(word) for word in data[1:]]
for i in range(int(data[0])):
    t = meeting(*case[10 * i : 10 * i + 10])
    print("none" if t is None else repr(t))
