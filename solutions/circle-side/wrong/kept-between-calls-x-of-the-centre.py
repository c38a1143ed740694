"""kept-between-calls

The distance squared is kept in a dict whose key leaves out the centre's x. Make all of the centre the key, or keep
nothing.
"""

squares = {}


def circle_side(cx, cy, r, P):
    square = squares.setdefault((cy, P), (P[0] - cx) ** 2 + (P[1] - cy) ** 2)
    return (square > r * r) - (square < r * r)
