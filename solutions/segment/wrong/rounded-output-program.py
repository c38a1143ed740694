"""rounded-output

The program prints with %.6f, and the digits after the sixth are lost.
Print repr(x): it is the shortest text that gives the double back.
"""

from math import hypot, sqrt

for _ in range(int(input())):
    cx, cy, r, x1, y1, x2, y2 = map(float, input().split())
    ax, ay, dx, dy = x1 - cx, y1 - cy, x2 - x1, y2 - y1
    near = 1e-10 * max(r, abs(ax), abs(ay), abs(x2 - cx), abs(y2 - cy))
    n = hypot(dx, dy)
    points = []
    if n == 0:
        if abs(hypot(ax, ay) - r) <= near:
            points.append((x1, y1))
    else:
        ux, uy = dx / n, dy / n
        d = abs(ux * ay - uy * ax)
        m = -(ux * ax + uy * ay)
        if d <= r + near:
            h = sqrt((r - d) * (r + d)) if d < r - near else 0
            for s in sorted({m - h, m + h}):
                if -near <= s <= n + near:
                    points.append((x1 + s * ux, y1 + s * uy))
    print(len(points), *["%.6f %.6f" % p for p in points])
