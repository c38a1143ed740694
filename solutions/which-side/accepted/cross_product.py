"""cross-product

The cross product of B - A and P - A is twice the area of the triangle A, B, P, and its sign says which way round
the three points go: above 0 is to the left.

Why it is exact: there are only differences and products of whole numbers, and no direction is special.
"""


def which_side(A, B, P):
    dx, dy = B[0] - A[0], B[1] - A[1]
    fx, fy = P[0] - A[0], P[1] - A[1]
    cross = dx * fy - dy * fx
    if cross > 0:
        return 1
    if cross < 0:
        return -1
    return 0
