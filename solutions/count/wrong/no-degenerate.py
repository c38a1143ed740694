"""no-degenerate

A == B is not looked at: the cross product and the length are both 0, and the formula says
"tangent". There is no line then; return None before anything else.
"""

import math


def line_count(cx, cy, r, A, B):
    ax, ay, bx, by = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    length = math.hypot(bx - ax, by - ay)
    k = abs((bx - ax) * ay - (by - ay) * ax)
    tolerance = 1e-10 * max(r, abs(ax), abs(ay), abs(bx), abs(by)) * length
    if abs(k - r * length) <= tolerance:
        return 1
    return 2 if k < r * length else 0
