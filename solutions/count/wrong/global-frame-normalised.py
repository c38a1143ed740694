"""global-frame

The line is written p·x + q·y = s with p² + q² = 1, and s is as large as the distance from the origin;
far away the difference to the centre's own p·x + q·y has lost the digits that decide. Subtract the
centre from A and B first.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    if A[0] == B[0] and A[1] == B[1]:
        return None
    n = hypot(B[0] - A[0], B[1] - A[1])
    p, q = (A[1] - B[1]) / n, (B[0] - A[0]) / n
    s = p * A[0] + q * A[1]
    d = abs(p * cx + q * cy - s)
    slack = 1e-10 * max(r, abs(A[0] - cx), abs(A[1] - cy), abs(B[0] - cx), abs(B[1] - cy))
    if d > r + slack:
        return 0
    return 1 if d >= r - slack else 2
