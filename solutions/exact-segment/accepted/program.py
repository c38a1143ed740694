"""program-with-two-ends

Reads the cases from standard input. The segment is cut at the foot of the perpendicular; each half runs
towards the circle or away from it, and has a point on it if its ends are not on the same side.
"""

import sys


def answer(cx, cy, r, ax, ay, bx, by):
    fx, fy, gx, gy = ax - cx, ay - cy, bx - cx, by - cy
    dx, dy = gx - fx, gy - fy
    a, b = dx * dx + dy * dy, fx * dx + fy * dy
    start, end = fx * fx + fy * fy - r * r, gx * gx + gy * gy - r * r
    if a == 0:
        return int(start == 0)
    if b >= 0 or b <= -a:  # the distance only rises, or only falls
        return int(min(start, end) <= 0 <= max(start, end))
    foot = (dx * fy - dy * fx) ** 2 - r * r * a  # of the sign that the foot's distance squared less r² has
    if foot == 0:
        return 1
    return int(foot < 0 <= start) + int(foot < 0 <= end)


def main():
    for line in sys.stdin.readlines()[1:]:
        if line.strip():
            print(answer(*map(int, line.split())))


main()
