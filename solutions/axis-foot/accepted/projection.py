"""projection

The foot on any line is A + t·D, with D = B - A and t = (P - A)·D / D·D. Multiplied first and divided last it stays
whole here: D has one coordinate that is 0, and the other one cancels.
"""


def axis_foot(A, B, P):
    dx, dy = B[0] - A[0], B[1] - A[1]
    along = (P[0] - A[0]) * dx + (P[1] - A[1]) * dy
    square = dx * dx + dy * dy
    return A[0] + along * dx // square, A[1] + along * dy // square
