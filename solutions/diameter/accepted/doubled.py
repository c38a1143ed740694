"""doubled

The figure is drawn twice as large, and then no half is left: twice the centre is A + B, and twice the radius is the
distance of A and B. The rest is a comparison of two squares.

Why it is exact: there are only sums, differences and products of whole numbers.
"""


def diameter_side(A, B, P):
    dx, dy = 2 * P[0] - A[0] - B[0], 2 * P[1] - A[1] - B[1]
    away = dx * dx + dy * dy
    across = (B[0] - A[0]) ** 2 + (B[1] - A[1]) ** 2
    if away < across:
        return -1
    if away > across:
        return 1
    return 0
