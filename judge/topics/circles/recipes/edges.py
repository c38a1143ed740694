"""Recipes at the edges of what is decided: just within a band or just outside of what is promised.

A tangency, an end, a point or an origin is there, on either side, whatever makes the extent. Each poses a
figure first and then gives it the radius that puts it there (figures/edges.py), which is checked.

`edges` names the ranges of shares, `sides` the sides; `scales` are powers of two of which one multiplies the
figure before that; `size` bounds the level figure's integers. What else is given goes to `posed` (posing.py).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from math import isqrt, ldexp
from typing import Any

from judge.data.draw import Draw, require
from judge.topics.circles.figures.edges import EDGES, Edge, point_off, root_off, tangent_off
from judge.topics.circles.figures.figure import Figure, Recipe, line, ray, typed, with_radius
from judge.topics.circles.figures.posing import closed_up, posed, stretched
from judge.topics.circles.recipes import counting, endpoints, rays
from judge.topics.circles.recipes.rays import well_conditioned

_ANYWHERE = ("near", "by", "far")
_STEPS = 6  # bounds a ray's level direction before it is stretched
_FARTHEST = 4  # powers of ten, in radii, that an end may be away
_SHORT = (17, 22)  # bits: a segment 2.4e-7 to 1.5e-5 of the extent long, which may hold a root
_TINY = (24, 50)  # and one that is too short for that
_FOOT = 100_000  # parts of 1e-5 of a radius
_SPECK = (41, 80)  # bits: a radius of at most 4.6e-13 of the extent


def tangent(
    draw: Draw,
    *,
    sides: Sequence[str],
    edges: Sequence[str],
    poses: Sequence[str],
    size: int = 1000,
    around: bool = False,
    close: Sequence[int] = (),
    scales: Sequence[int] = (0,),
    **pose: Any,
) -> Figure:
    """A line that is, or nearly is, a tangent; each of A and B lies near the foot, by the circle or far away.

    With `around` the foot lies between them. With `close`, B lies 2**-bits of the extent from A, those being
    its bounds.
    """
    radius = _radius(draw, size)
    reach = draw.choice((_ANYWHERE, _ANYWHERE, ("near",)))  # of both, so that the radius may be the extent
    start, end = _place(draw, radius, reach), _place(draw, radius, reach)
    if start == end:
        draw.reject()
    if around and start * end > 0:
        end = -end
    height = radius * draw.sign()
    figure = _posed(draw, line((0, 0), radius, (start, height), (end, height)), poses, scales, pose)
    if close:
        figure = closed_up(draw, figure, close)
    return _finished(draw, tangent_off(draw, figure, _edge(draw, edges), _side(draw, sides, "hit", "miss")))


def away(
    draw: Draw,
    *,
    sides: Sequence[str],
    edges: Sequence[str],
    ratio: Sequence[int],
    poses: Sequence[str],
    size: int = 1000,
    scales: Sequence[int] = (0,),
    **pose: Any,
) -> Figure:
    """A line that is, or nearly is, a tangent; A and B are `ratio` radii away, and a radius apart at most."""
    radius = _radius(draw, size)
    height, start = radius * draw.sign(), radius * draw.integer(*ratio) * draw.sign()
    end = start + draw.integer(radius // 8, radius) * draw.sign()
    figure = _posed(draw, line((0, 0), radius, (start, height), (end, height)), poses, scales, pose)
    return _finished(draw, tangent_off(draw, figure, _edge(draw, edges), _side(draw, sides, "hit", "miss")))


def at_foot(
    draw: Draw,
    *,
    apart: Sequence[str],
    poses: Sequence[str],
    size: int = 1000,
    scales: Sequence[int] = (0,),
    **pose: Any,
) -> Figure:
    """A tangent by points 1e-6 to 1e-5 of the radius from where it touches: within the band of the circle.

    A and B are on either side of the foot ("across"), on the same one ("beside"), or 5e-10 of the radius
    from each other ("short").
    """
    radius = _radius(draw, size)
    start, end = (draw.integer(_FOOT // 10, _FOOT) * radius for _ in range(2))
    kind = draw.choice(apart)
    require(kind in ("across", "beside", "short"), f"{kind!r} says how far A and B are apart")
    if kind == "across":
        end = -end
    elif kind == "short":
        end = start + radius * _FOOT // 20_000
    if start == end:
        draw.reject()
    radius *= _FOOT * 100_000
    figure = line((0, 0), radius, (start, radius * draw.sign()), (end, radius * draw.sign()))
    return _finished(draw, _posed(draw, figure, poses, scales, pose))


def ray_tangent(
    draw: Draw,
    *,
    sides: Sequence[str],
    edges: Sequence[str],
    poses: Sequence[str],
    size: int = 1000,
    stretch: Sequence[int] = (0, 0),
    scales: Sequence[int] = (0,),
    ratio: Sequence[int] = (),
    **pose: Any,
) -> Figure:
    """A ray that is, or nearly is, a tangent, its point of contact well ahead, by `ratio` radii if given."""
    radius = _radius(draw, size)
    away = (
        radius * draw.integer(*ratio)
        if ratio
        else {
            "near": draw.integer(radius // 4, radius * 2 // 5),
            "by": draw.integer(radius, 3 * radius),
            "far": draw.integer(radius, 9 * radius) * 10 ** draw.integer(1, 2),
        }[draw.choice(("near", "by", "far"))]
    )
    figure = ray((0, 0), radius, (-away, radius * draw.sign()), (draw.integer(1, _STEPS), 0))
    figure = _posed(draw, figure, poses, scales, pose)
    figure = tangent_off(draw, figure, _edge(draw, edges), _side(draw, sides, "hit", "miss"))
    require(well_conditioned(1.0, 1.0 - 1e-7, -away / radius), "the first root is known well")
    return _finished(draw, stretched(figure, draw.integer(*stretch)))


def ray_at_foot(
    draw: Draw,
    *,
    where: Sequence[str],
    poses: Sequence[str],
    size: int = 1000,
    stretch: Sequence[int] = (0, 0),
    scales: Sequence[int] = (0,),
    **pose: Any,
) -> Figure:
    """A tangent whose point of contact is 1e-6 to 1e-5 of the radius from the origin, ahead of it or behind:
    the origin is within the band of the circle, that point is not within the band of the origin.
    """
    radius = _radius(draw, size)
    start = draw.integer(_FOOT // 10, _FOOT) * radius
    if _side(draw, where, "ahead", "behind") == "ahead":
        start = -start
    radius *= _FOOT * 100_000
    figure = ray((0, 0), radius, (start, radius * draw.sign()), (draw.integer(1, _STEPS) << 40, 0))
    return _finished(draw, stretched(_posed(draw, figure, poses, scales, pose), draw.integer(*stretch)))


def end(
    draw: Draw,
    *,
    sides: Sequence[str],
    edges: Sequence[str],
    others: Sequence[str],
    poses: Sequence[str],
    size: int = 1000,
    scales: Sequence[int] = (0,),
    **pose: Any,
) -> Figure:
    """A segment one of whose ends is nearly on the circle: the root is on the segment ("on") or "beyond" it.

    The other end is inside the circle (inward), beyond its other side (across), outside on the near side
    (outward), far away (far), or close to the first (short, tiny).
    """
    radius = _radius(draw, size)
    height = _height(draw, radius)
    half = _half(radius, height)
    kind = draw.choice(others)
    places = {
        "inward": half // 2,
        "across": half + draw.integer(1, radius),
        "outward": -half - draw.integer(1, radius),
        "far": draw.sign() * radius * draw.integer(1, 9) * 10 ** draw.integer(1, _FARTHEST),
        "short": half,
        "tiny": half,
    }
    require(kind in places, f"{kind!r} is a place for the other end")
    figure = _posed(draw, line((0, 0), radius, (-half, height), (places[kind], height)), poses, scales, pose)
    side = _side(draw, sides, "on", "beyond")
    if kind in ("short", "tiny"):
        figure = closed_up(draw, figure, _SHORT if kind == "short" else _TINY)
    figure = root_off(draw, figure, _edge(draw, edges), 0, 1 if side == "on" else -1)
    if draw.boolean():
        figure = line(figure.centre, figure.radius, figure.points[1], figure.points[0])
    return _finished(draw, figure)


def point(
    draw: Draw,
    *,
    sides: Sequence[str],
    edges: Sequence[str],
    poses: Sequence[str],
    size: int = 1000,
    scales: Sequence[int] = (0,),
    **pose: Any,
) -> Figure:
    """A segment that is one point, A == B, nearly on the circle."""
    radius = _radius(draw, size)
    figure = _posed(draw, line((0, 0), radius, (radius, 0), (radius, 0)), poses, scales, pose)
    return _finished(
        draw, point_off(draw, figure, _edge(draw, edges), _side(draw, sides, "inside", "outside"))
    )


def origin(
    draw: Draw,
    *,
    sides: Sequence[str],
    looks: Sequence[str],
    edges: Sequence[str],
    poses: Sequence[str],
    size: int = 1000,
    stretch: Sequence[int] = (0, 0),
    scales: Sequence[int] = (0,),
    **pose: Any,
) -> Figure:
    """A ray whose origin is nearly on the circle, the root "ahead" or "behind"; it looks "in" or "out"."""
    radius = _radius(draw, size)
    height = _height(draw, radius)
    half = _half(radius, height)
    look = _side(draw, looks, "in", "out")
    start = -half if look == "in" else half
    figure = ray((0, 0), radius, (start, height), (draw.integer(1, _STEPS), 0))
    figure = _posed(draw, figure, poses, scales, pose)
    side = _side(draw, sides, "ahead", "behind")
    figure = root_off(draw, figure, _edge(draw, edges), 0, 1 if side == "ahead" else -1)
    return _finished(draw, stretched(figure, draw.integer(*stretch)))


def speck(recipe: Recipe, draw: Draw, **parameters: Any) -> Figure:
    """A recipe's figure of r = 0 with a radius that is not 0 but drowns in the band."""
    figure = recipe(draw, **parameters)
    require(figure.radius == 0, "a speck is nearly a point")
    radius = ldexp(float(figure.extent) or 1.0, -draw.integer(*_SPECK))
    return typed(draw, with_radius(figure, radius), "any")


def _radius(draw: Draw, size: int) -> int:
    return draw.integer(max(8, size // 2), size)


def _place(draw: Draw, radius: int, reach: Sequence[str]) -> int:
    """A place on the line, seen from the foot."""
    kind = draw.choice(reach)
    if kind == "near":
        place = draw.integer(1, radius // 3)
    elif kind == "by":
        place = draw.integer(radius, 3 * radius)
    else:
        place = draw.integer(radius, 9 * radius) * 10 ** draw.integer(1, _FARTHEST)
    return place * draw.sign()


def _height(draw: Draw, radius: int) -> int:
    """How far a line that is cut at a good angle passes from the centre; every fourth runs through it."""
    return draw.integer(-radius * 4 // 5, radius * 4 // 5) if draw.integer(0, 3) else 0


def _half(radius: int, height: int) -> int:
    """The half-chord, up to a unit: the radius is chosen anew."""
    return isqrt(radius * radius - height * height)


def _posed(
    draw: Draw, figure: Figure, poses: Sequence[str], scales: Sequence[int], pose: dict[str, Any]
) -> Figure:
    return posed(draw, figure, poses=poses, numbers="float", scale=draw.choice(scales), **pose)


def _finished(draw: Draw, figure: Figure) -> Figure:
    return typed(draw, figure, "any")


def _edge(draw: Draw, names: Sequence[str]) -> Edge:
    name = draw.choice(names)
    require(name in EDGES, f"{name!r} is an edge, one of {', '.join(EDGES)}")
    return EDGES[name]


def _side(draw: Draw, sides: Sequence[str], *known: str) -> str:
    side = draw.choice(sides)
    require(side in known, f"{side!r} is a side, one of {', '.join(known)}")
    return side


LINES: Mapping[str, Recipe] = {
    "tangent-edge": tangent,
    "away": away,
    "at-foot": at_foot,
    "speck": partial(speck, counting.zero_radius),
}
SEGMENTS: Mapping[str, Recipe] = {
    "tangent-edge": tangent,
    "at-foot": at_foot,
    "end-edge": end,
    "point-edge": point,
    "speck": partial(speck, endpoints.point_circle),
}
RAYS: Mapping[str, Recipe] = {
    "tangent-edge": ray_tangent,
    "at-foot": ray_at_foot,
    "origin-edge": origin,
    "speck": partial(speck, rays.point_circle),
}
