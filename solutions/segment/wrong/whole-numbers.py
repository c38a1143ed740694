"""whole-numbers

The input is cut down to whole numbers with int().
Leave ints and floats as they are; Python computes with both.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    cx, cy, r = int(cx), int(cy), int(r)
    x1, y1 = map(int, A)
    x2, y2 = map(int, B)
    ax, ay, dx, dy = x1 - cx, y1 - cy, x2 - x1, y2 - y1
    near = 1e-10 * max(r, abs(ax), abs(ay), abs(x2 - cx), abs(y2 - cy))
    n = hypot(dx, dy)
    if n == 0:
        return [(x1, y1)] if abs(hypot(ax, ay) - r) <= near else []
    ux, uy = dx / n, dy / n
    d = abs(ux * ay - uy * ax)
    if d > r + near:
        return []
    h = sqrt((r - d) * (r + d)) if d < r - near else 0
    m = -(ux * ax + uy * ay)
    return [(x1 + s * ux, y1 + s * uy) for s in sorted({m - h, m + h}) if -near <= s <= n + near]
