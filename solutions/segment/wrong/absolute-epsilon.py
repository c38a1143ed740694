"""absolute-epsilon

Tangency and ends are compared with 1e-9, whatever the size of the figure.
Make the epsilon a small part of the extent: 1e-10 times the largest of r and the coordinates seen from the centre.
"""

import math

EPS = 1e-9


def circle_segment(cx, cy, r, A, B):
    x1, y1 = A[0] - cx, A[1] - cy
    x2, y2 = B[0] - cx, B[1] - cy
    dx, dy = x2 - x1, y2 - y1
    length = math.hypot(dx, dy)
    if length < EPS:
        return [A] if abs(math.hypot(x1, y1) - r) < EPS else []
    ux, uy = dx / length, dy / length
    dist = x1 * uy - y1 * ux
    mid = -(x1 * ux + y1 * uy)
    if abs(dist) > r + EPS:
        return []
    if abs(abs(dist) - r) <= EPS:
        places = [mid]
    else:
        h = math.sqrt(r * r - dist * dist)
        places = [mid - h, mid + h]
    return [(A[0] + s * ux, A[1] + s * uy) for s in places if -EPS <= s <= length + EPS]
