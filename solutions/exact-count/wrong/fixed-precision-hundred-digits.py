"""fixed-precision

Decimals with 100 digits: enough until the products have 101. With numbers of any size no fixed precision is
enough; ints have none.
"""

from decimal import Decimal, getcontext

getcontext().prec = 100


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
