"""one-scale

Ends, tangencies and points are all there, but every figure has about the size of 10 and lies at the origin. A threshold
that is a fixed number, or measured by the wrong length, does as well as a right one there, and no digits are lost. Give the
same figure again tiny, huge, far away, and with one end very far.
"""


def cases():
    return [
        (2, 1, 5, (9, 4), (-7, -2)),
        (2, 1, 5, (2, 1), (-20, -23)),
        (0, 0, 5, (3, 4), (-5, 0)),
        (0, 0, 1, (-3, 1), (4, 1)),
        (0, 0, 1, (2, 1), (4, 1)),
        (0, 0, 1, (-2, -1.000001), (2, -1.000001)),
        (0, 0, 5, (3, 4), (3, 4)),
        (0, 0, 0, (-1, -1), (2, 2)),
        (0, 0, 5, (0, 1), (2, 1)),
        (1, 2, 3, (1, -9), (1, 9)),
    ]
