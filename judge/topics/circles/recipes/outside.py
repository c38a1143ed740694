"""Recipes for a circle and a point that its tangents run through: beside it, far away, at its centre.

Each draws a figure of one point. What goes to `posed` is explained there (posing.py).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from judge.data.draw import Draw
from judge.topics.circles.figures.figure import Figure, Recipe, as_ints, draw_point, typed
from judge.topics.circles.figures.posing import posed
from judge.topics.circles.recipes import points

_BOUND = 1 << 28  # of whole numbers, so that their differences stay within the bounds as well


def outside(draw: Draw, *, ratio: Sequence[int], size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """A point clearly outside the circle, x or y up to so many radii away as `ratio` bounds."""
    radius = draw.integer(1, size)
    low, high = ratio
    octave = draw.integer(low.bit_length() - 1, high.bit_length() - 1)
    away = radius * min(high, max(low, draw.integer(1 << octave, 2 << octave)))
    place = away, draw.integer(-away, away)
    if place[0] ** 2 + place[1] ** 2 <= radius * radius:
        draw.reject()
    return posed(draw, Figure((0, 0), radius, (place,)), poses=poses, **pose)


def centre(draw: Draw, *, size: int, poses: Sequence[str], or_point: bool = False, **pose: Any) -> Figure:
    """A point that is the circle's centre; with `or_point` the circle may be a point as well."""
    radius = 0 if or_point and draw.integer(0, 3) == 0 else draw.integer(1, size)
    x, y = draw_point(draw, size)
    return posed(draw, Figure((x, y), radius, ((x, y),)), poses=poses, centre=0, **pose)


def anywhere(draw: Draw, *, size: int) -> Figure:
    """Everything anywhere: whole numbers up to the bounds, or small ones that are divided."""
    if draw.boolean():
        figure = Figure(draw_point(draw, _BOUND), draw.integer(1, _BOUND), (draw_point(draw, _BOUND),))
        return typed(draw, figure, "any")
    figure = Figure((0, 0), draw.integer(1, size), (draw_point(draw, 3 * size),))
    return posed(draw, figure, poses=("any",), divisor=draw.integer(1, size))


def whole(draw: Draw) -> Figure:
    """Ints up to the bounds: P on the circle, off by one in |f|² − r², nearly on it, anywhere."""
    if draw.integer(0, 2) == 0:
        return Figure(draw_point(draw, _BOUND), draw.integer(1, _BOUND), (draw_point(draw, _BOUND),))
    return as_ints(points.whole(draw))


RECIPES: Mapping[str, Recipe] = {"outside": outside, "centre": centre, "anywhere": anywhere, "whole": whole}
