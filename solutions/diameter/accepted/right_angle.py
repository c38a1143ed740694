"""right-angle

By Thales' theorem P is on the circle exactly where A and B are seen from it at a right angle, which makes their
scalar product 0. Inside the angle is wider and the product below 0, outside it is above 0.
"""


def diameter_side(A, B, P):
    dot = (A[0] - P[0]) * (B[0] - P[0]) + (A[1] - P[1]) * (B[1] - P[1])
    return (dot > 0) - (dot < 0)
