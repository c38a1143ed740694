"""loose-epsilon

The squared distance is an exact fraction, and then 1e-9 around r² passes for a tangent. Here there is no
tolerance at all: compare with ==.
"""

from fractions import Fraction


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    square = Fraction(k * k, dx * dx + dy * dy)
    if abs(square - r * r) < Fraction(1, 10**9):
        return 1
    return 2 if square < r * r else 0
