"""tangent-missed

Only a line that is clearly closer than the radius counts as meeting the circle, so that a tangent
gets 0. A tangent has one point in common with the circle: answer 1 within the band.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == dy == 0:
        return None
    nx, ny = -dy / hypot(dx, dy), dx / hypot(dx, dy)
    d = abs((A[0] - cx) * nx + (A[1] - cy) * ny)
    extent = max(r, abs(A[0] - cx), abs(A[1] - cy), abs(B[0] - cx), abs(B[1] - cy))
    return 2 if r - d > 1e-10 * extent else 0
