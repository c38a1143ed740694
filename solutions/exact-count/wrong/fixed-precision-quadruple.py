"""fixed-precision

Decimals with 34 digits, as of a quadruple-precision float: fourth powers leave them from coordinates of a
hundred million on. With numbers of any size no fixed precision is enough; ints have none.
"""

from decimal import Decimal, getcontext

getcontext().prec = 34


def exact_count(cx, cy, r, A, B):
    cx, cy, r, ax, ay, bx, by = (Decimal(v) for v in (cx, cy, r, *A, *B))
    dx, dy = B[0] - A[0], B[1] - A[1]
    dx, dy = bx - ax, by - ay
    if dx == 0 and dy == 0:
        return None
    k = dx * (ay - cy) - dy * (ax - cx)
    reach = r * r * (dx * dx + dy * dy)
    if k * k == reach:
        return 1
    return 2 if k * k < reach else 0
