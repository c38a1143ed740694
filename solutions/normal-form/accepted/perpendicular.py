"""perpendicular

The direction turned to the left by a quarter and made one long; then c from the point A.

(−Dy, Dx) is D turned to the left: (1, 0), which looks to the right, becomes (0, 1). Divided by its
length, its product with any vector is how far that vector goes to the left of the line. Seen from
A that is the signed distance, a·(x − Ax) + b·(y − Ay), and what is left of it without x and y is
c = −(a·Ax + b·Ay).
"""

from math import hypot


def normal_form(A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    length = hypot(dx, dy)
    a, b = -dy / length, dx / length
    return a, b, -(a * A[0] + b * A[1])
