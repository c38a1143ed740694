"""fixed-precision

Decimals as they come, with 28 digits: from coordinates of about ten million on, the fourth powers
have more. With numbers of any size no fixed precision is enough; ints have none.
"""

from decimal import Decimal


def exact_count(cx, cy, r, A, B):
    cx, cy, r, ax, ay, bx, by = map(Decimal, (cx, cy, r, *A, *B))
    if ax == bx and ay == by:
        return None
    dx, dy = bx - ax, by - ay
    k = dx * (ay - cy) - dy * (ax - cx)
    gap = r * r * (dx * dx + dy * dy) - k * k
    return 1 + gap.compare(Decimal(0)).to_integral_value().__int__()
