"""compare-lengths

Seen from the centre, the cross product of B - A and A - C is |B - A| times the distance of the line from C. That
distance is compared with the radius, within 1e-9 of the figure's size.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    fx, fy = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    size = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    distance = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if abs(distance - r) <= 1e-9 * size:
        return 1
    return 2 if distance < r else 0
