"""only-a-miss

All cases miss the circle by far, and nearly every wrong program answers those rightly. Let most cases have points.
"""


def cases():
    return [(0, 0, 1, (-5, y), (5, y)) for y in range(2, 14)]
