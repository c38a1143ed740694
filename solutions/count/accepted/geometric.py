"""distance-from-the-cross-product

Everything is seen from the centre. The cross product of B - A and A - C is |B - A| times the
distance of the line from C, and keeps its precision wherever A and B lie along the line. The
distance is then compared with the radius, within a fraction of the case's own extent.
"""

from math import hypot

THRESHOLD = 1e-10


def line_count(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    extent = max(r, abs(ax), abs(ay), abs(B[0] - cx), abs(B[1] - cy))
    distance = abs(dx * ay - dy * ax) / hypot(dx, dy)
    if abs(distance - r) <= THRESHOLD * extent:
        return 1
    return 2 if distance < r else 0
