"""rounded-output

Six decimals are printed: at a size of 1e-6 nothing of the figure is left. Print all digits of a number, as
repr does.
"""

from math import hypot, sqrt


def main():
    for _ in range(int(input())):
        cx, cy, r, px, py = map(float, input().split())
        fx, fy = px - cx, py - cy
        d = hypot(fx, fy)
        found = []
        if r == 0:
            found = [(cx, cy)]
        elif abs(d - r) <= 1e-10 * max(d, r):
            found = [(px, py)]
        elif d > r:
            a, b = (r / d) ** 2, r / d * (sqrt((d - r) * (d + r)) / d)
            found = [(cx + a * fx + s * b * fy, cy + a * fy - s * b * fx) for s in (1, -1)]
        print(len(found), *("%.6f %.6f" % point for point in found))


main()
