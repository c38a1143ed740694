"""forgotten-centre

The circle is treated as if its centre were the origin. Subtract C from both points before anything
else.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    (x1, y1), (x2, y2) = A, B
    if x1 == x2 and y1 == y2:
        return None
    dx, dy = x2 - x1, y2 - y1
    distance = abs(dx * y1 - dy * x1) / hypot(dx, dy)
    extent = max(r, abs(x1), abs(y1), abs(x2), abs(y2))
    if abs(distance - r) <= 1e-10 * extent:
        return 1
    return 2 if distance < r else 0
