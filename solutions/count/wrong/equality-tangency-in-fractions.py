"""equality-tangency

Everything is exact, so that a tangent whose numbers were rounded to doubles is a hit or a miss by 1e-17.
Apply the statement's band, which says what the truth is.
"""

from fractions import Fraction


def line_count(cx, cy, r, A, B):
    cx, cy, r = Fraction(cx), Fraction(cy), Fraction(r)
    A = Fraction(A[0]), Fraction(A[1])
    B = Fraction(B[0]), Fraction(B[1])
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    k = dx * fy - dy * fx
    reach = r * r * (dx * dx + dy * dy)
    if k * k == reach:
        return 1
    return 2 if k * k < reach else 0
