"""many-digits

Right, and hundreds of times slower than it need be: every root is worked out to six thousand digits and
then rounded to the sixteen of a double.
"""

from decimal import Decimal, getcontext

getcontext().prec = 6_000


def circle_segment(cx, cy, r, A, B):
    cx, cy, r = Decimal(cx), Decimal(cy), Decimal(r)
    ax, ay = Decimal(A[0]) - cx, Decimal(A[1]) - cy
    bx, by = Decimal(B[0]) - cx, Decimal(B[1]) - cy
    dx, dy = bx - ax, by - ay
    near = max(r, abs(ax), abs(ay), abs(bx), abs(by)) / 10**10
    length = (dx * dx + dy * dy).sqrt()
    if length == 0:
        return [tuple(A)] if abs((ax * ax + ay * ay).sqrt() - r) <= near else []
    ux, uy = dx / length, dy / length
    foot, height = -(ax * ux + ay * uy), ux * ay - uy * ax
    if abs(abs(height) - r) <= near:
        places = [foot]
    elif abs(height) > r:
        places = []
    else:
        half = (r * r - height * height).sqrt()
        places = [foot - half, foot + half]
    return [
        (float(cx + ax + place * ux), float(cy + ay + place * uy))
        for place in places
        if -near <= place <= length + near
    ]
