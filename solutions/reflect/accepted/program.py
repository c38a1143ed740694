"""program

A whole program: T on the first line, then a case a line; answers `px py rx ry` or `none`. By angles: with half the
chord and the height it knows the sine and the cosine of the normal against the ray, and turns D by twice that angle.
"""

import sys
from math import sqrt


def reflected(cx, cy, r, ox, oy, dx, dy):
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
    half = 0.0 if abs(side) >= r - eps else sqrt((r - side) * (r + side))
    if lead - half >= -eps:
        way, cosine = lead - half, -half / r
    elif lead + half >= -eps:
        way, cosine = lead + half, half / r
    else:
        return None
    sine = side / r
    # −n²·conj(D), with n at that angle to D
    turn, lift = (1 - 2 * cosine * cosine, -2 * cosine * sine) if half else (1.0, 0.0)
    return ox + way * ux, oy + way * uy, turn * dx - lift * dy, lift * dx + turn * dy


def main():
    lines = sys.stdin.read().splitlines()
    for line in lines[1 : 1 + int(lines[0])]:
        found = reflected(*map(float, line.split()))
        print("none" if found is None else "%r %r %r %r" % found)


main()
