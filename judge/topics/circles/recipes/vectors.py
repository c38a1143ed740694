"""Recipes for a circle and a ray whose answer is a vector: the circle is no tiny part of the figure.

What goes to `posed` is explained in posing.py, `where` in rays.py.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from judge.data.draw import Draw, require
from judge.topics.circles.figures.figure import Figure, Recipe, draw_point, ray, typed
from judge.topics.circles.figures.posing import posed
from judge.topics.circles.recipes import rays
from judge.topics.circles.recipes.edges import ray_tangent

_STEPS = 6  # bounds a level direction
_LEAST = 1000  # radii that make the extent at most, of what is drawn anywhere


def anywhere(draw: Draw, *, size: int, numbers: str = "any") -> Figure:
    """Centre and origin anywhere in ±size, a radius up to size, and in every second figure a hit."""
    centre, origin, direction = (draw_point(draw, size) for _ in range(3))
    radius = draw.integer(size // _LEAST, size)
    if draw.boolean():
        direction = centre[0] - origin[0] + draw.integer(-radius, radius) // 2, centre[1] - origin[1]
    if direction == (0, 0) or max(map(abs, direction)) > size:
        draw.reject()
    return typed(draw, ray(centre, radius, origin, direction), numbers)


def head_on(draw: Draw, *, size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """A ray through the centre, from outside or inside; in every sixth figure from C itself."""
    radius = draw.integer(1, size)
    place = draw.choice(("outside", "outside", "outside", "inside", "inside", "centre"))
    starts = {
        "outside": -radius - draw.integer(1, 2 * size),
        "inside": draw.integer(1 - radius, radius - 1),
        "centre": 0,
    }
    return posed(
        draw, ray((0, 0), radius, (starts[place], 0), (draw.integer(1, _STEPS), 0)), poses=poses, **pose
    )


def no_hit(draw: Draw, *, of: Sequence[str], size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """A ray that is none (null), or a circle that is a point (point), wherever the origin is."""
    kind = draw.choice(of)
    require(kind in ("null", "point"), f"{kind!r} is a way to have nothing to hit")
    if kind == "null":
        return rays.null_direction(
            draw, where=("on", "inside", "outside", "point"), size=size, poses=poses, **pose
        )
    where = ("ahead", "ahead", "behind", "off", "at-origin")
    return rays.point_circle(draw, where=where, size=size, poses=poses, **pose)


def offset(
    draw: Draw,
    *,
    where: Sequence[str],
    sides: Sequence[str],
    edges: Sequence[str],
    scale: int,
    far: int,
    **pose: Any,
) -> Figure:
    """A small figure up to 2**far from the origin: a clear hit (`where`), or nearly a touch (`sides`)."""
    if draw.boolean():
        return rays.across(draw, where=where, scale=scale, centre=0, far=far, **pose)
    return ray_tangent(draw, sides=sides, edges=edges, scales=[scale], centre=0, far=far, **pose)


RECIPES: Mapping[str, Recipe] = {"anywhere": anywhere, "head-on": head_on, "no-hit": no_hit, "offset": offset}
