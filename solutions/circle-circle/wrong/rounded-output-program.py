"""rounded-output

Six decimals are printed: at a size of 1e-6 nothing of the figure is left. Print all digits of a number, as
repr does.
"""

from math import hypot, sqrt


def common(cx1, cy1, r1, cx2, cy2, r2):
    vx, vy = cx2 - cx1, cy2 - cy1
    d = hypot(vx, vy)
    near = 1e-10 * max(r1, r2, d)
    if d <= near:
        return [(cx1, cy1)] if r1 == r2 == 0 else None if abs(r1 - r2) <= near else []
    if d > r1 + r2 + near or d < abs(r1 - r2) - near:
        return []
    a = (d + (r1 - r2) * (r1 + r2) / d) / 2
    h = sqrt(max(0.0, r1 * r1 - a * a))
    if d >= r1 + r2 - near or d <= abs(r1 - r2) + near:
        return [(cx1 + a * vx / d, cy1 + a * vy / d)]
    return [(cx1 + (a * vx - s * vy) / d, cy1 + (a * vy + s * vx) / d) for s in (h, -h)]


def main():
    for _ in range(int(input())):
        found = common(*map(float, input().split()))
        print("none" if found is None else " ".join([str(len(found)), *("%.6f %.6f" % each for each in found)]))


main()
