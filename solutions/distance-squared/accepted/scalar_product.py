"""scalar-product

The vector Q - P times itself: |Q - P|² = Q·Q - 2·P·Q + P·P. Whole numbers lose nothing by that, however large
the three terms are.
"""


def distance_squared(P, Q):
    def dot(u, v):
        return sum(a * b for a, b in zip(u, v))

    return dot(Q, Q) - 2 * dot(P, Q) + dot(P, P)
