"""happy-path-only

Every case goes through the circle at two points, or through one, at sane sizes. A program that is wrong at a tangency,
at an end, for a point or far away answers them all rightly. For each decision a program takes, add a case where it turns.
"""


def cases():
    return [
        (0, 0, 5, (-6, 3), (6, 3)),
        (2, 1, 5, (9, 4), (-7, -2)),
        (0, 0, 5, (0, 0), (9, 1)),
        (1, 2, 3, (-5, 1), (5, 4)),
        (-3, 2, 4, (3, 9), (-6, -7)),
    ]
