"""Recipes for a circle and a point: far from the origin, and in whole numbers of any size.

Each draws a figure of one point. What goes to `posed` is explained there (posing.py).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from judge.data.draw import Draw, require
from judge.topics.circles.figures.figure import Figure, Recipe, draw_mirrored, draw_point, typed
from judge.topics.circles.figures.numbers import off_by_one
from judge.topics.circles.figures.posing import posed, rational_chord
from judge.topics.circles.recipes.whole import BOUND, whole_segment

_WHOLE = ("on", "point", "one", "one", "corners", "corners")
_SIDES = ("inside", "on", "outside")


def grid(draw: Draw, *, size: int) -> Figure:
    """Everything from a small grid: coordinates up to ±size, radius up to size."""
    centre, point = draw_point(draw, size), draw_point(draw, size)
    return Figure(centre, draw.integer(0, size), (point,))


def around(draw: Draw, *, where: Sequence[str], size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """A point clearly inside or outside the circle, or on it by Pythagoras."""
    radius, height, half = rational_chord(draw, size)
    kind = draw.choice(where)
    require(kind in _SIDES, f"{kind!r} is one of {', '.join(_SIDES)}")
    if kind == "inside":
        radius += draw.integer(1, size)
    elif kind == "outside":
        radius = draw.integer(0, radius - 1)
    return posed(draw, Figure((0, 0), radius, ((half, height),)), poses=poses, **pose)


def point_circle(draw: Draw, *, size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """A circle of radius 0, and its centre, or another point."""
    place = draw_point(draw, draw.choice((0, size)))
    # The circle is beside the origin, so that a case is told from the next one.
    x, y = draw_point(draw, size)
    return posed(draw, Figure((x, y), 0, ((x + place[0], y + place[1]),)), poses=poses, centre=0, **pose)


def whole(draw: Draw, *, kinds: Sequence[str] = _WHOLE) -> Figure:
    """Whole numbers up to the bounds: exactly on the circle, off by one in |f|² − r², or nearly on it.

    ones: off by one, and all of them ints; corners: P and the centre are opposite corners of the bounds, so
    that |f|² alone leaves 64 bits; reach: the circle reaches from one end of the bounds 2³⁰ beyond it.
    """
    kind = draw.choice(kinds)
    if kind == "corners":
        x, y = BOUND * draw.sign(), BOUND * draw.sign()
        return Figure((x, y), draw.choice((0, draw.integer(1, BOUND))), ((-x, -y),))
    if kind == "reach":
        away, (cy, y) = draw.integer(0, BOUND + BOUND // 2), draw_point(draw, BOUND // 2)
        return draw_mirrored(draw, Figure((BOUND, cy), BOUND, ((BOUND - away, y),)))
    if kind not in ("one", "ones"):
        figure = whole_segment(draw, kinds=(kind,))
        on = [point for point in figure.points if _gap(figure, point) == 0 or kind == "point"]
        return Figure(figure.centre, figure.radius, (on[0],))
    x, y, radius = off_by_one(draw, 1 << draw.integer(22, 28), draw.sign())
    if radius < 1 << 20:
        draw.reject()  # the band is that of a large circle
    cx, cy = draw_point(draw, 1 << 29)
    return typed(draw, Figure((cx, cy), radius, ((cx + x, cy + y),)), "any" if kind == "one" else "int")


def _gap(figure: Figure, point: tuple[float, float]) -> float:
    x, y = point[0] - figure.centre[0], point[1] - figure.centre[1]
    return x * x + y * y - figure.radius**2


RECIPES: Mapping[str, Recipe] = {
    "grid": grid,
    "around": around,
    "point-circle": point_circle,
    "whole": whole,
}
