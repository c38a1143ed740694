"""fixed-precision

The squared distance is a quotient of decimals of 120 digits, compared with r² by ==. Quotients need not
come out even, and products of more than 60 digits do not fit. Compare r²·a with k² in ints.
"""

from decimal import Decimal, getcontext

getcontext().prec = 120


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    dx, dy, fx, fy = map(Decimal, (dx, dy, A[0] - cx, A[1] - cy))
    square = (dx * fy - dy * fx) ** 2 / (dx * dx + dy * dy)
    radius = Decimal(r)
    if square == radius * radius:
        return 1
    return 2 if square < radius * radius else 0
