"""Between a figure and the arguments of a call: which of them are places in the plane, and in what order.

The flat signature is (cx, cy, r, points …, vectors …): a circle's numbers one by one, points and vectors as
pairs. An adapter makes a case of a figure, so that one recipe serves problems of different signatures.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache, wraps
from itertools import pairwise
from typing import Any

from msgspec import Struct

from judge.data.draw import Draw
from judge.problem import Case, Parameter, ParameterType
from judge.problem.model import Number, Point
from judge.topics.circles.figures.figure import Figure, Recipe

Adapter = Callable[[Figure], Case]
Change = Callable[[Number, Number], Point]  # of a point or vector, by its coordinates

_PAIRS = (ParameterType.POINT, ParameterType.INTEGER_POINT)


def flat(figure: Figure) -> Case:
    """The arguments cx, cy, r, the points, the vectors."""
    return (*figure.centre, figure.radius, *figure.points, *figure.vectors)


def builders(recipes: Mapping[str, Recipe], adapter: Adapter = flat) -> dict[str, Callable[..., Case]]:
    """A problem's BUILDERS: each recipe's figure as a case."""
    return {name: _adapted(recipe, adapter) for name, recipe in recipes.items()}


def _adapted(recipe: Recipe, adapter: Adapter) -> Callable[..., Case]:
    @wraps(recipe)
    def builder(draw: Draw, **parameters: Any) -> Case:
        return adapter(recipe(draw, **parameters))

    return builder


class Layout(Struct, frozen=True):
    """The places in a case that hold points and vectors: pairs, and an x whose y is the next argument."""

    pairs: tuple[int, ...]
    split: tuple[int, ...]

    def mapped(self, case: Case, change: Change) -> Case:
        """The case with every point and vector changed."""
        values: list[Any] = list(case)
        for place in self.pairs:
            x, y = values[place]
            values[place] = change(x, y)
        for place in self.split:
            values[place], values[place + 1] = change(values[place], values[place + 1])
        return tuple(values)


@lru_cache(maxsize=64)
def layout(parameters: tuple[Parameter, ...]) -> Layout:
    """Where the points and vectors of a problem's cases are: cx and cy are one, as x1 and y1 are."""
    pairs = [place for place, each in enumerate(parameters) if each.type in _PAIRS]
    names = [None if each.type in _PAIRS else each.name for each in parameters]
    split = [
        place
        for place, (x, y) in enumerate(pairwise(names))
        if x is not None and y is not None and x != y and x.replace("x", "y") == y
    ]
    return Layout(tuple(pairs), tuple(split))


def circle_and_pairs(case: Case) -> tuple[Point, Number, Point, Point] | None:
    """The centre, the radius and the two pairs of a flat case that has so many; None for any other case."""
    if len(case) != 5:
        return None
    cx, cy, radius, p, q = case
    if isinstance(cx, tuple) or isinstance(cy, tuple) or isinstance(radius, tuple):
        return None
    if not isinstance(p, tuple) or not isinstance(q, tuple):
        return None
    return (cx, cy), radius, p, q
