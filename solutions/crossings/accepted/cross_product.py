"""cross-product

The distance of C from the line is |k| / |B - A|, with the cross product k of B - A and C - A. It is compared with r
after both were squared and multiplied by |B - A|², so that nothing is divided and no root is taken.

Why it is exact: there are only differences and products of whole numbers.
"""


def crossings(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    k = dx * (cy - A[1]) - dy * (cx - A[0])
    away, reach = k * k, r * r * (dx * dx + dy * dy)
    if away < reach:
        return 2
    if away > reach:
        return 0
    return 1
