"""Recipes from end to end of the bounds: differences of two numbers come to 2³¹, and 32 bits end below."""

from __future__ import annotations

from collections.abc import Mapping

from judge.data.draw import Draw
from judge.topics.circles.figures.figure import Figure, Recipe
from judge.topics.circles.recipes.whole import BOUND

_FREE = 3  # of so many numbers and one more that need not be at an end, one is


def bounds(draw: Draw, *, points: int) -> Figure:
    """A circle and so many points in ints; in x, and in y, two are at the opposite ends of the bounds."""
    places = tuple(zip(_row(draw, points + 1), _row(draw, points + 1), strict=True))
    radius = draw.choice((BOUND, BOUND, BOUND, draw.integer(BOUND // 2, BOUND), draw.integer(0, BOUND)))
    return Figure(places[0], radius, places[1:])


def _row(draw: Draw, count: int) -> list[int]:
    """So many numbers: the least that there may be, the greatest, and others, in any order."""
    row = [
        BOUND * draw.sign() if draw.integer(0, _FREE) == 0 else draw.integer(-BOUND, BOUND)
        for _ in range(count)
    ]
    low = draw.integer(0, count - 1)
    row[low] = -BOUND
    row[(low + draw.integer(1, count - 1)) % count] = BOUND
    return row


RECIPES: Mapping[str, Recipe] = {"bounds": bounds}
