"""kept-between-calls

The way from A to B is worked out once for each A, so that another B is never looked at. Work it out in every call.
"""


def which_side(A, B, P, ways={}):
    dx, dy = ways.setdefault(A, (B[0] - A[0], B[1] - A[1]))
    cross = dx * (P[1] - A[1]) - dy * (P[0] - A[0])
    return (cross > 0) - (cross < 0)
