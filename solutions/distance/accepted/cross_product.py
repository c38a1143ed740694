"""cross product

The area of the parallelogram that B - A and A - P span, by the length of its base.

Two sides of a parallelogram from one corner, D and f, have the cross product Dx·fy - Dy·fx as its
area, with a sign that says on which side P is. The base is |D|, the height is the distance: one
division gives it. The foot of the perpendicular may be anywhere on the line, and is never computed.

P is subtracted before anything is multiplied, so that a figure far from the origin keeps its
digits; and the division comes last, so that the product of whole numbers is exact until then.
"""

from math import hypot


def distance(A, B, P):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - P[0], A[1] - P[1]
    return abs(dx * fy - dy * fx) / hypot(dx, dy)
