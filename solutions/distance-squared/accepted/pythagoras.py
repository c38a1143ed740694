"""pythagoras

The way along x and the way along y are the short sides of a right-angled triangle. The distance is its long
side, and the square of that is the sum of their squares.

Why it is exact: there are only differences, products and a sum of whole numbers. The sign of a difference does
not matter, for it is squared.
"""


def distance_squared(P, Q):
    dx = Q[0] - P[0]
    dy = Q[1] - P[1]
    return dx * dx + dy * dy
