"""kept-between-calls

The function is cached by the line alone: another point gets the foot of the first one. Make all three points the
key, or keep nothing.
"""

feet = {}


def foot(A, B, C):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    if (A, B) not in feet:
        t = ((C[0] - A[0]) * dx + (C[1] - A[1]) * dy) / (dx * dx + dy * dy)
        feet[A, B] = t, (A[0] + t * dx, A[1] + t * dy)
    return feet[A, B]
