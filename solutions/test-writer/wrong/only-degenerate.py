"""only-degenerate

The cases are all points: A = B or r = 0. These are two decisions of many; the formula itself is never asked for. Keep two
or three of them, and give the rest to segments that meet the circle, touch it and miss it.
"""


def cases():
    return [
        (0, 0, 5, (3, 4), (3, 4)),
        (0, 0, 5, (3, 4.00001), (3, 4.00001)),
        (0, 0, 0, (-1, -1), (2, 2)),
        (0, 0, 0, (0, 0), (0, 0)),
        (1e4, 0, 6.5, (1e4 + 2.5, 6), (1e4 + 2.5, 6)),
        (0, 0, 5e-9, (3e-9, 4.00001e-9), (3e-9, 4.00001e-9)),
    ]
