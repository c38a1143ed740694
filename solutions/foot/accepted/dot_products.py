"""dot products

The arrow from A to C is projected onto the arrow from A to B.

f·D is |D| times the length of the projection, with the sign of its direction; D·D is |D|². So their
quotient is the projection in lengths of D, which is the parameter t, and A + t·D is the foot. Neither
a root nor an angle is needed, and an upright line is like any other.

A is subtracted from C before anything is multiplied: a small figure far from the origin keeps its
digits. When A and B are much closer together than C is, t is large, and A + t·D is known as well as
the direction of D is.
"""


def foot(A, B, C):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    t = ((C[0] - A[0]) * dx + (C[1] - A[1]) * dy) / (dx * dx + dy * dy)
    return t, (A[0] + t * dx, A[1] + t * dy)
