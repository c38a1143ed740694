"""unnormalised-distance

The cross product is compared with the radius as it is. It is the distance times |B - A|: divide by
that length first.
"""


def line_count(cx, cy, r, A, B):
    if tuple(A) == tuple(B):
        return None
    x1, y1 = A[0] - cx, A[1] - cy
    x2, y2 = B[0] - cx, B[1] - cy
    d = abs(x1 * y2 - x2 * y1)
    extent = max(r, abs(x1), abs(y1), abs(x2), abs(y2))
    if abs(d - r) <= 1e-10 * extent:
        return 1
    return 2 if d < r else 0
