"""unnormalised-distance

The cross product is compared with the radius itself, although it is the distance times |B - A|.
Compare k² with r²·a.
"""


def exact_count(cx, cy, r, A, B):
    if A[0] == B[0] and A[1] == B[1]:
        return None
    d = abs((B[0] - A[0]) * (A[1] - cy) - (B[1] - A[1]) * (A[0] - cx))
    if d == r:
        return 1
    return 2 if d < r else 0
