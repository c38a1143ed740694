"""coordinates

On a level line the foot has P's x and the line's y; on an upright line it is the other way round. Nothing has to be
computed.
"""


def axis_foot(A, B, P):
    if A[1] == B[1]:
        return (P[0], A[1])
    return (A[0], P[1])
