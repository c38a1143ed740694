"""many-digits

Right, and hundreds of times slower than it need be: the distance is worked out to six thousand digits,
where the promised gap between a tangent and any other line leaves a double plenty of room.
"""

from decimal import Decimal, getcontext

getcontext().prec = 6_000


def line_count(cx, cy, r, A, B):
    ax, ay = Decimal(A[0]) - Decimal(cx), Decimal(A[1]) - Decimal(cy)
    bx, by = Decimal(B[0]) - Decimal(cx), Decimal(B[1]) - Decimal(cy)
    dx, dy = bx - ax, by - ay
    if dx == 0 and dy == 0:
        return None
    radius = Decimal(r)
    size = max(radius, abs(ax), abs(ay), abs(bx), abs(by))
    distance = abs(dx * ay - dy * ax) / (dx * dx + dy * dy).sqrt()
    gap = distance - radius
    if abs(gap) <= size / 10**10:
        return 1
    return 2 if gap < 0 else 0
