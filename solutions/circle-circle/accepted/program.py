"""program

A whole program: T on the first line, then a case a line. The unit vector is turned by the angle's cosine and sine.
"""

import sys
from math import hypot, sqrt


def answer(x1, y1, p, x2, y2, q):
    dx, dy = x2 - x1, y2 - y1
    d = hypot(dx, dy)
    eps = 1e-10 * max(p, q, d)
    if d <= eps:
        if abs(p - q) > eps:
            return "0"
        return "none" if p or q else f"1 {x1!r} {y1!r}"
    outer, inner = d - p - q, d - abs(p - q)
    if outer > eps or inner < -eps:
        return "0"
    ux, uy = dx / d * p, dy / d * p
    if outer >= -eps or inner <= eps:
        if outer < -eps and p < q:
            ux, uy = -ux, -uy
        return f"1 {x1 + ux!r} {y1 + uy!r}"
    # 1 − cos = (q − (d − p))(q + (d − p)) / (2pd), and the sine from it
    versine = (q - d + p) * ((q + d - p) / p) / (2 * d)
    cosine, sine = 1 - versine, sqrt(max(0.0, versine * (2 - versine)))
    points = [(x1 + cosine * ux - s * uy, y1 + s * ux + cosine * uy) for s in (sine, -sine)]
    return " ".join(["2", *(repr(x) for point in points for x in point)])


def main():
    lines = sys.stdin.read().splitlines()
    print("\n".join(answer(*map(float, line.split())) for line in lines[1 : 1 + int(lines[0])]))


main()
