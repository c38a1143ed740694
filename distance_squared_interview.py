"""distance-squared: The distance squared.

`judge show distance-squared` shows the whole statement, `judge hint` the next hint.
`judge start distance-squared` judges this file on every save.
"""

IntPoint = tuple[int, int]


def distance_squared(P: IntPoint, Q: IntPoint) -> int:
    """How far apart two points are, squared, so that it stays a whole number.

    - P and Q are pairs `(x, y)` of whole numbers, from -1000000000 to 1000000000. They
      may be the same point.
    - Return a whole number, an `int`. There is no root to take.

    From (1, 2) to (4, 6) it is 3 along x and 4 along y. The distance is √(3² + 4²) = 5,
    and the answer is 25.

    ## Examples

    >>> distance_squared((1, 2), (4, 6))
    25
    >>> distance_squared((0, 0), (1, 1))
    2
    >>> distance_squared((3, -2), (-1, -2))
    16
    >>> distance_squared((7, 7), (7, 7))
    0
    >>> distance_squared((0, 0), (1000000000, 1))
    1000000000000000001
    """
    raise NotImplementedError("distance_squared is still to be written")
