"""one-direction

Every segment runs from left to right, so that nothing shows in which order the points are wanted: sorted by x they come
out the same. Turn some of the segments round.
"""


def cases():
    return [
        (2, 1, 5, (-7, -2), (9, 4)),
        (0, 0, 5, (-6, 3), (6, 3)),
        (0, 0, 1, (-3, 1), (4, 1)),
        (0, 0, 5, (0, 1), (2, 1)),
        (3, 0, 1, (0, 3), (1, 9)),
        (-1, -3, 3, (-1, -3), (3, 0)),
        (1.5, 2.25, 3.125, (-9.5, 1), (9, 4.5)),
    ]
