"""kept-between-calls

Lines are kept in a dict whose key is A alone, so that another line through the same A gets the first one's
direction. Make both points the key, or keep nothing.
"""

from math import hypot

known = {}


def normal_form(A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    if A not in known:
        a, b = -dy / hypot(dx, dy), dx / hypot(dx, dy)
        known[A] = a, b, -(a * A[0] + b * A[1])
    return known[A]
