"""Recipes for a line through two points and a point beside it: where its foot is, and how far away.

Each draws a figure of two points, A and B, about a circle of radius 0, the point P. A problem that has no P
takes the points alone. `size` bounds the level figure's integers before its pose enlarges or divides them;
what else is given goes to `posed` (posing.py).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from judge.data.draw import Draw, require
from judge.topics.circles.figures.figure import Figure, Recipe, draw_point, line, moved, scaled, typed
from judge.topics.circles.figures.lines import placed, primitive, with_cross
from judge.topics.circles.figures.posing import closed_up, posed
from judge.topics.circles.recipes import counting

_MOST_CROSS = 9  # twice the area of a thin triangle
_AWAY = 1 << 29  # bounds where its point is


def grid(draw: Draw, *, size: int) -> Figure:
    """Everything from a small grid, the degenerate included."""
    point, a, b = (draw_point(draw, size) for _ in range(3))
    return line(point, 0, a, b)


def uniform(draw: Draw, *, size: int, numbers: str = "any") -> Figure:
    """The three points anywhere in ±size; in every fourth figure A and B are opposite corners, in ints."""
    figure = grid(draw, size=size)
    if draw.integer(0, 3) == 0:
        x, y = size * draw.sign(), size * draw.sign()
        point = draw.choice((figure.centre, (-x, -y), (x, -y)))
        return line(point, 0, (x, y), (-x, -y))
    return typed(draw, figure, numbers)


def beside(
    draw: Draw,
    *,
    feet: Sequence[str],
    size: int,
    poses: Sequence[str],
    on: bool = False,
    longer: Sequence[int] = (0, 0),
    close: Sequence[int] = (),
    scales: Sequence[int] = (0,),
    **pose: Any,
) -> Figure:
    """A point whose foot is before A, between A and B, after B, or at-end; `on` puts it on the line itself.

    `longer` (bounds) is by how many octaves A and B are farther apart than `size`; with `close`, B is
    2**-bits of the extent from A, those being its bounds. `scales` are powers of two.
    """
    kind = draw.choice(feet)
    length = draw.integer(1, size) << draw.integer(*longer)
    gap = draw.integer(1, size)
    inner = draw.integer(0, draw.choice((length, min(gap, length))))  # anywhere, or near A
    starts = {"before": gap, "after": -length - gap, "between": -inner, "at-end": 0}
    require(kind in starts, f"{kind!r} is a place for a foot")
    start = starts[kind]
    height = 0 if on else draw.integer(1, size)
    figure = line((0, 0), 0, (start, height), (start + length, height))
    figure = posed(draw, figure, poses=poses, numbers="float", scale=draw.choice(scales), **pose)
    if close:
        figure = closed_up(draw, figure, close)
    return typed(draw, figure, "any")


def remote(draw: Draw, *, size: int, far: int, finest: int) -> Figure:
    """A line and a point of a small grid, which is divided by up to 2**finest, and is about `far` away.

    There the coordinates of a foot are hardly ever doubles, and their rounding is much for such a figure.
    """
    figure = grid(draw, size=size)
    if figure.points[0] == figure.points[1]:
        draw.reject()
    figure = scaled(figure, -draw.integer(0, finest))
    dx, dy = (draw.sign() * draw.integer(far // 2, far) for _ in range(2))
    return typed(draw, moved(figure, dx, dy), "any")


def thin(draw: Draw, *, size: int) -> Figure:
    """P so close to the line that |D × f| is at most 9, for D of about `size`.

    A and B are no more than 4·size from P, so that doubles hold the product exactly; P is anywhere.
    """
    require(8 * size < _AWAY, "there is room for it within the bounds")
    direction = primitive(draw.integer(size // 2, size) * draw.sign(), draw.integer(1, size) * draw.sign())
    if max(map(abs, direction)) < size // 4:
        draw.reject()
    f = with_cross(direction, draw.integer(1, _MOST_CROSS) * draw.sign(), draw.integer(-2, 1))
    return typed(draw, placed(draw_point(draw, _AWAY), 0, f, direction), "any")


RECIPES: Mapping[str, Recipe] = {
    "grid": grid,
    "uniform": uniform,
    "beside": beside,
    "remote": remote,
    "thin": thin,
    "degenerate": counting.degenerate,
}
