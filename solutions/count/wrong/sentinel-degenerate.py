"""sentinel-degenerate

A == B is noticed, but answered with -1, as one would in a language without None. The contract says
None.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    if A[0] == B[0] and A[1] == B[1]:
        return -1
    dx, dy = B[0] - A[0], B[1] - A[1]
    fx, fy = A[0] - cx, A[1] - cy
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
