"""absolute-epsilon

The distance is compared with the radius within a fixed 1e-9, whatever the size of the figure: a
tiny circle is all epsilon, and at coordinates of 1e8 rounding alone is more than that. Measure the
epsilon by the extent of the case.
"""

import math

EPS = 1e-9


def line_count(cx, cy, r, A, B):
    (x1, y1), (x2, y2) = A, B
    dx, dy = x2 - x1, y2 - y1
    if dx == 0 and dy == 0:
        return None
    d = abs(dx * (y1 - cy) - dy * (x1 - cx)) / math.sqrt(dx * dx + dy * dy)
    if d > r + EPS:
        return 0
    if d < r - EPS:
        return 2
    return 1
