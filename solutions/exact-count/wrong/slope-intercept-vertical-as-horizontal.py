"""slope-intercept

Where the slope would be a division by zero it is set to 0, so that a vertical line is treated as a
horizontal one. Work with the direction B − A.
"""

from fractions import Fraction


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    m = Fraction(dy, dx) if dx else 0
    n = (A[1] - cy) - m * (A[0] - cx)
    if n * n == r * r * (m * m + 1):
        return 1
    return 2 if n * n < r * r * (m * m + 1) else 0
