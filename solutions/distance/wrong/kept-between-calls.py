"""kept-between-calls

Lines are kept in a dict whose key is A alone, so that another line through the same A gets the first one's
direction. Make both points the key, or keep nothing.
"""

from math import hypot

lines = {}


def distance(A, B, P):
    if A[0] == B[0] and A[1] == B[1]:
        return None
    if A not in lines:
        length = hypot(B[0] - A[0], B[1] - A[1])
        lines[A] = B[0] - A[0], B[1] - A[1], length
    dx, dy, length = lines[A]
    return abs(dx * (A[1] - P[1]) - dy * (A[0] - P[0])) / length
