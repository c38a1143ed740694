"""rounded-input

The numbers are rounded to six decimal places "to get rid of noise". What is beyond the sixth place
may be what decides. A float is exactly the double it is: leave the input alone.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    cx, cy, r, ax, ay, bx, by = (round(v, 6) for v in (cx, cy, r, *A, *B))
    if (ax, ay) == (bx, by):
        return None
    extent = max(r, abs(ax - cx), abs(ay - cy), abs(bx - cx), abs(by - cy))
    d = abs((bx - ax) * (ay - cy) - (by - ay) * (ax - cx)) / hypot(bx - ax, by - ay)
    if abs(d - r) <= 1e-10 * extent:
        return 1
    return 2 if d < r else 0
