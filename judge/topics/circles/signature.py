"""Between a figure and the arguments of a call: which of them are places in the plane, and in what order.

The flat signature is (cx, cy, r, points …, vectors …): a circle's numbers one by one, points and vectors as
pairs. An adapter makes a case of a figure, so that one recipe serves problems of different signatures;
`read` and `line_of` go the other way.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import wraps
from typing import Any

from msgspec.structs import replace

from judge.data.draw import Draw
from judge.problem import Case
from judge.problem.model import Number, Point
from judge.topics.circles.figures.figure import Figure, Recipe
from judge.topics.circles.line import CircleLine
from judge.topics.circles.pair import CirclePair
from judge.topics.circles.part import Part

Adapter = Callable[[Figure], Case]


def flat(figure: Figure) -> Case:
    """The arguments cx, cy, r, the points, the vectors."""
    return (*figure.centre, figure.radius, *figure.points, *figure.vectors)


def circle_and_point(figure: Figure) -> Case:
    """The arguments cx, cy, r, P; P is the figure's first point."""
    return (*figure.centre, figure.radius, figure.points[0])


def circle_and_polygon(figure: Figure) -> Case:
    """The arguments cx, cy, r, V; V is all of the figure's points."""
    return (*figure.centre, figure.radius, figure.points)


def two_circles(figure: Figure) -> Case:
    """The arguments cx1, cy1, r1, cx2, cy2, r2; C2 is the figure's first point, and r2 its first length."""
    return (*figure.centre, figure.radius, *figure.points[0], figure.lengths[0])


def line_and_point(figure: Figure) -> Case:
    """The arguments A, B, P; P is the figure's centre."""
    return (*figure.points, figure.centre)


def line_alone(figure: Figure) -> Case:
    """The arguments A, B."""
    return figure.points


def circles_and_ray(figure: Figure) -> Case:
    """The arguments circles, O, D: the points are the circles' centres, and O is the figure's own."""
    radii = (figure.radius, *figure.lengths)
    circles = tuple((*place, r) for place, r in zip(figure.points, radii, strict=True))
    return circles, figure.centre, figure.vectors[0]


def circles_ray_and_light(figure: Figure) -> Case:
    """The arguments circles, O, D, L: the last point is the light."""
    *places, light = figure.points
    return *circles_and_ray(replace(figure, points=tuple(places))), light


def points_only(figure: Figure) -> Case:
    """The points alone, of a problem without a circle."""
    return figure.points


def builders(*recipes: Mapping[str, Recipe], adapter: Adapter = flat) -> dict[str, Callable[..., Case]]:
    """A problem's BUILDERS: each recipe's figure as a case; of two of a name the latter."""
    return {name: _adapted(recipe, adapter) for each in recipes for name, recipe in each.items()}


def _adapted(recipe: Recipe, adapter: Adapter) -> Callable[..., Case]:
    @wraps(recipe)
    def builder(draw: Draw, **parameters: Any) -> Case:
        return adapter(recipe(draw, **parameters))

    return builder


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


def read(part: Part, case: Case) -> tuple[Point, Number, Point, Point] | None:
    """The centre, the radius and the two pairs that such a case stands for; None for any other case."""
    if part.of_point and len(case) == 4:
        return circle_and_pairs((*case, case[3]))
    if part is Part.FOOT and len(case) == 3 and all(isinstance(each, tuple) for each in case):
        return case[2], 0, case[0], case[1]
    if part is Part.NORMAL and len(case) == 2 and all(isinstance(each, tuple) for each in case):
        return (0, 0), 0, case[0], case[1]
    if part.of_point or part.of_pair or part.of_crowd or part in (Part.FOOT, Part.NORMAL):
        return None
    return circle_and_pairs(case)


def line_of(part: Part, case: Case) -> CircleLine | None:
    """The same as a circle and a directed line in integers."""
    if part.of_pair:
        plain = len(case) == 6 and not any(isinstance(each, tuple) for each in case)
        return CirclePair.of(*case).circles()[0] if plain else None
    found = read(part, case)
    if found is None:
        return None
    centre, radius, first, second = found
    build = CircleLine.ray if part.of_ray else CircleLine.through
    return build(*centre, radius, first, second)
