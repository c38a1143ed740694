"""kept-between-calls

Normals are kept in a dict whose key is B alone. Make both points the key, or keep nothing.
"""

from math import hypot

normals = {}


def normal_form(A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    a, b = normals.setdefault(B, (-dy / hypot(dx, dy), dx / hypot(dx, dy)))
    return a, b, -(a * A[0] + b * A[1])
