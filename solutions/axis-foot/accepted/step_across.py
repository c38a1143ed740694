"""step-across

One step along the line is u, and how far P is from the line is the cross product of u and P - A. Go back from P by
just that much, at a right angle to u.
"""


def axis_foot(A, B, P):
    dx, dy = B[0] - A[0], B[1] - A[1]
    length = abs(dx) + abs(dy)
    ux, uy = dx // length, dy // length  # one of them is 0, the other one 1 or -1
    across = ux * (P[1] - A[1]) - uy * (P[0] - A[0])
    return P[0] + across * uy, P[1] - across * ux
