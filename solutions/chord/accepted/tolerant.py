"""half-chord, with a tolerance

Pythagoras in the triangle of the centre, the foot of the perpendicular and an end of the chord.

The longest side is r, one of the others is d, the distance of the line from the centre, and the third
is half of the chord. The cross product of D and f = A − C gives d wherever A and B are on the line.

Whether the line touches is decided by lengths, d and r, within 1e-9 of the size, before any root is
taken: next to 0 a root turns an error of 1e-16 into one of 1e-8. Under the root stands
(r − d)(r + d), which is exact to the last digits where d is close to r.
"""

from math import hypot, sqrt


def chord_length(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    near = 1e-9 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    if d > r + near:
        return None
    if d >= r - near:
        return 0
    return 2 * sqrt((r - d) * (r + d))
