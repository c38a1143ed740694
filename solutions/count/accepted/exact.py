"""fractions

A float is a fraction, so nothing needs to be rounded: the line cuts, touches or misses as k² is less than, equal to
or greater than r²·|D|², where k is the cross product of D = B - A and A - C.
"""

from fractions import Fraction


def line_count(cx, cy, r, A, B):
    cx, cy, r, ax, ay, bx, by = map(Fraction, (cx, cy, r, *A, *B))
    dx, dy = bx - ax, by - ay
    if dx == dy == 0:
        return None
    k = dx * (ay - cy) - dy * (ax - cx)
    left, right = k * k, r * r * (dx * dx + dy * dy)
    return 2 if left < right else 1 if left == right else 0
