"""signed-extent

The coordinates seen from the centre go into the extent with their signs: a point far to the left or
below counts for nothing, and the threshold is too narrow for it. Take their absolute values.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    if tuple(A) == tuple(B):
        return None
    ax, ay, bx, by = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    extent = max(r, ax, ay, bx, by)
    distance = abs((bx - ax) * ay - (by - ay) * ax) / hypot(bx - ax, by - ay)
    if abs(distance - r) <= 1e-10 * extent:
        return 1
    return 0 if distance > r else 2
