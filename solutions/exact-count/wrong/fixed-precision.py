"""fixed-precision

Decimals with 50 digits: enough until the products have 51. With numbers of any size no fixed
precision is enough; ints have none.
"""

from decimal import Decimal, getcontext

getcontext().prec = 50


def exact_count(cx, cy, r, A, B):
    cx, cy, r = Decimal(cx), Decimal(cy), Decimal(r)
    ax, ay = map(Decimal, A)
    bx, by = map(Decimal, B)
    dx, dy = bx - ax, by - ay
    if dx == 0 and dy == 0:
        return None
    k = dx * (ay - cy) - dy * (ax - cx)
    reach = r * r * (dx * dx + dy * dy)
    if reach == k * k:
        return 1
    return 2 if reach > k * k else 0
