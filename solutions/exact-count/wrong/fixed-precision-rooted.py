"""fixed-precision

The distance is computed in decimals of 60 digits, with a division and a root. Tangents need not come out even. Compare r²·a with k² in ints.
"""

from decimal import Decimal, localcontext


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = abs(dx * (A[1] - cy) - dy * (A[0] - cx))
    with localcontext() as context:
        context.prec = 60
        d = Decimal(k) / Decimal(dx * dx + dy * dy).sqrt()
    if d == r:
        return 1
    return 2 if d < r else 0
