"""breaks-the-promise

A case misses the circle by less than the promise allows, where right programs may differ: it is no test. Let a near miss
be off by a millionth of the figure, and let what touches touch exactly.
"""


def cases():
    return [
        (2, 1, 5, (9, 4), (-7, -2)),
        (0, 0, 1, (-2, 1.000000001), (2, 1.000000001)),
    ]
