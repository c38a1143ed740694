"""kept-between-calls

Lines are kept in a dict whose key is A alone, so that another line through the same A gets the first one's
direction. Make both points the key, or keep nothing.
"""

lines = {}


def foot(A, B, C):
    if A[0] == B[0] and A[1] == B[1]:
        return None
    dx, dy = lines.setdefault(A, (B[0] - A[0], B[1] - A[1]))
    t = ((C[0] - A[0]) * dx + (C[1] - A[1]) * dy) / (dx * dx + dy * dy)
    return t, (A[0] + t * dx, A[1] + t * dy)
