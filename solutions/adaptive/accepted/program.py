"""program-with-a-filter

Reads the cases from standard input; doubles first, integers where they do not decide.
"""

import sys


def exact(*numbers):
    ratios = [x.as_integer_ratio() for x in numbers]
    unit = max([bottom for _, bottom in ratios])
    cx, cy, r, ax, ay, bx, by = [top * (unit // bottom) for top, bottom in ratios]
    dx, dy = bx - ax, by - ay
    k = dx * (ay - cy) - dy * (ax - cx)
    delta = r * r * (dx * dx + dy * dy) - k * k
    return (delta > 0) - (delta < 0)


def sign(cx, cy, r, ax, ay, bx, by):
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    p, q = dx * fy, dy * fx
    k, m = p - q, abs(p) + abs(q)
    reach = r * r * (dx * dx + dy * dy)
    delta = reach - k * k
    bound = 1.2e-16 * (16 * reach + 18 * m * abs(k)) + 1.3e-30 * m * m
    if delta > bound:
        return 1
    if delta < -bound:
        return -1
    return exact(cx, cy, r, ax, ay, bx, by)


def main():
    lines = sys.stdin.read().split("\n")[1:]
    print("\n".join(str(sign(*map(float, line.split()))) for line in lines if line))


main()
