"""whole-root

The whole part of the root decides where it is r or more than r, and whether something was left over says the rest:
isqrt(n) is the greatest whole number whose square is at most n.
"""

from math import isqrt


def circle_side(cx, cy, r, P):
    square = (P[0] - cx) ** 2 + (P[1] - cy) ** 2
    root = isqrt(square)
    if root != r:
        return -1 if root < r else 1
    return 0 if root * root == square else 1
