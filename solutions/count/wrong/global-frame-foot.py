"""global-frame

The foot of the perpendicular is computed as a point of the plane, with coordinates that have no
digits to spare far from the origin, and only then measured from the centre. Subtract the centre
first: the foot then has small coordinates.
"""

from math import dist


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    t = ((cx - A[0]) * dx + (cy - A[1]) * dy) / (dx * dx + dy * dy)
    foot = (A[0] + t * dx, A[1] + t * dy)
    d = dist(foot, (cx, cy))
    e = max(r, abs(A[0] - cx), abs(A[1] - cy), abs(B[0] - cx), abs(B[1] - cy))
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
