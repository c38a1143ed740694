"""turned-arrow

The arrow from A to B, turned by a quarter to the left, is (-dy, dx). P is on the left where the way from A to P goes
along with that arrow: their scalar product is above 0.
"""


def which_side(A, B, P):
    left = (A[1] - B[1], B[0] - A[0])
    along = sum(n * (p - a) for n, p, a in zip(left, P, A))
    return (along > 0) - (along < 0)
