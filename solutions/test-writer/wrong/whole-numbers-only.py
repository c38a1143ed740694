"""whole-numbers-only

Small whole numbers are computed without any rounding, and so no tolerance is ever needed: a touch comes out equal, an
end exactly on the circle. Turn a figure by a Pythagorean angle, and make its numbers large.
"""


def cases():
    return [
        (2, 1, 5, (9, 4), (-7, -2)),
        (2, 1, 1, (2, 2), (0, 1)),
        (0, 0, 5, (3, 4), (3, 4)),
        (0, 0, 1, (-3, 1), (4, 1)),
        (2, 1, 1, (-1, 0), (-3, 0)),
        (3, 0, 1, (0, 3), (0, 0)),
        (0, -1, 0, (-3, -3), (0, -1)),
        (1, 0, 3, (1, 0), (-1, 0)),
        (0, 0, 5, (0, 1), (2, 1)),
        (-1, -3, 3, (-1, -3), (-3, 0)),
    ]
