"""program

A whole program: T on the first line, then a case a line; answers `t` or `none`.
"""

import sys
from math import hypot, sqrt


def impact(px, py, qx, qy, r, ax, ay, bx, by):
    eps = max(r, *(abs(z) for z in (ax - px, ay - py, ax - qx, ay - qy, bx - px, by - py, bx - qx, by - qy))) * 1e-10
    vx, vy, wx, wy = qx - px, qy - py, bx - ax, by - ay
    long = wx * wx + wy * wy
    at = ((px - ax) * wx + (py - ay) * wy) / long if long else 0
    at = min(1, max(0, at))
    if hypot(px - ax - at * wx, py - ay - at * wy) <= r + eps:
        return 0
    speed = hypot(vx, vy)
    if speed == 0:
        return None
    best = 2 + eps
    for x, y in ((ax - px, ay - py), (bx - px, by - py)):
        lead, side = (x * vx + y * vy) / speed, abs(x * vy - y * vx) / speed
        if side < r - eps:
            lead -= sqrt((r - side) * (r + side))
        if side <= r + eps and lead >= 0:
            best = min(best, lead / speed)
    rate = vx * wy - vy * wx
    if rate:
        for offset in (-r, r):  # the wall's line moved to either side
            t = ((ax - px) * wy - (ay - py) * wx + offset * sqrt(long)) / rate
            foot = (px + t * vx - ax) * wx + (py + t * vy - ay) * wy
            if t >= 0 and 0 <= foot <= long:
                best = min(best, t)
    return best if (best - 1) * speed <= eps else None


data = sys.stdin.read().split()
case = [float(word) for word in data[1:]]
for i in range(int(data[0])):
    t = impact(*case[9 * i : 9 * i + 9])
    print("none" if t is None else repr(t))
