"""Recipes for a circle that an infinite line cuts: through its centre, and given by points near or far.

Each draws a figure of two points, A and B. What goes to `posed` is explained there (posing.py).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isqrt, ldexp
from typing import Any

from judge.data.draw import Draw
from judge.topics.circles.figures.figure import Figure, Recipe, line, typed
from judge.topics.circles.figures.posing import posed
from judge.topics.circles.recipes import edges, endpoints

_PARTS = 10**9  # of a radius, in which a small distance is counted


def diameter(
    draw: Draw, *, size: int, poses: Sequence[str], beside: Sequence[int] = (), **pose: Any
) -> Figure:
    """A line through the centre; A and B anywhere on it.

    With `beside` it passes the centre by 1 in every third figure, and the bounds of the radius are these.
    """
    height = 1 if beside and draw.integer(0, 2) == 0 else 0
    radius = draw.integer(*beside) if height else draw.integer(1, size)
    reach = 2 * (radius if height else size)
    start = draw.integer(-reach, reach - 1)
    figure = line((0, 0), radius, (start, height), (draw.integer(start + 1, reach), height))
    return posed(draw, figure, poses=poses, **pose)


def from_centre(draw: Draw, *, size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """A line from the centre to anywhere, or from there to the centre: A or B is the centre itself."""
    ends = (0, 0), (draw.integer(1, 2 * size), 0)
    figure = line((0, 0), draw.integer(1, size), *ends[:: -1 if draw.boolean() else 1])
    return posed(draw, figure, poses=poses, **pose)


def off_centre(draw: Draw, *, size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """A line past the centre by 1e-8 to 1e-2 of the radius, all magnitudes alike; A and B on either side."""
    radius = draw.integer(max(2, size // 2), size)
    offset = draw.integer(1, 9) * radius * 10 ** draw.integer(1, 6) * draw.sign()
    start, end = -draw.integer(radius, 2 * size), draw.integer(radius, 2 * size)
    figure = line((0, 0), radius * _PARTS, (start * _PARTS, offset), (end * _PARTS, offset))
    return posed(draw, figure, poses=poses, **pose)


def spread(draw: Draw, *, size: int, octaves: Sequence[int], poses: Sequence[str], **pose: Any) -> Figure:
    """A line that cuts the circle; A and B are 2**octaves (bounds, which may be negative) of its size apart.

    Where they are close together A is inside the circle: rounding turns the line, and it cuts all the same.
    """
    octave = draw.integer(*octaves)
    radius = draw.integer(2, size)
    offset = draw.integer(1 - radius, radius - 1)
    inner = isqrt(radius * radius - offset * offset - 1)
    start = draw.integer(-size, size) if octave >= 0 else draw.integer(-inner, inner)
    length = draw.integer(1, size) << max(0, octave)
    figure = line((0, 0), radius, (start, offset), (start + length, offset))
    figure = posed(draw, figure, poses=poses, numbers="float", **pose)
    if octave < 0:
        (ax, ay), (bx, by) = figure.points
        near = ax + ldexp(bx - ax, octave), ay + ldexp(by - ay, octave)
        if near == (ax, ay):
            draw.reject()
        figure = line(figure.centre, figure.radius, (ax, ay), near)
    return typed(draw, figure, "any")


def touch_edge(draw: Draw, *, close: Sequence[int], ratio: Sequence[int], **parameters: Any) -> Figure:
    """A line that is, or nearly is, a tangent: one of three kinds.

    Its points are anywhere on it; or B is 2**-close of the extent from A; or one coordinate of one of them,
    `ratio` radii away, is all of the extent, and the line is off by most of the band.
    """
    kind = draw.integer(0, 2)
    if kind == 2:
        scale = draw.choice(parameters["scales"])
        return endpoints.lopsided(draw, size=500, ratio=ratio, scale=scale)
    return edges.tangent(draw, close=close if kind else (), **parameters)


RECIPES: Mapping[str, Recipe] = {
    "diameter": diameter,
    "from-centre": from_centre,
    "off-centre": off_centre,
    "spread": spread,
    "touch-edge": touch_edge,
}
