"""sum-of-legs

The legs are added up, which is the way around the corner. Add their squares, and take the root.
"""


def two_points(P, Q):
    return abs(Q[0] - P[0]) + abs(Q[1] - P[1])
