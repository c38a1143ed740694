"""Recipes for a sphere and a ray: where the origin is, which root comes first, and how nearly.

Most lay a level ray as those of a circle and a ray do, and then turn its plane into space. What goes to
`placed` is explained in figures.py. `edges` names ranges of shares of the extent (those of circles), `sides`
the sides; of `scales`, powers of two, one multiplies the scene.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial, wraps
from math import isqrt
from typing import Any

from msgspec.structs import replace

from judge.data.draw import Draw, require
from judge.topics.circles.figures.edges import EDGES, Edge
from judge.topics.circles.figures.figure import Figure, ray
from judge.topics.circles.recipes import rays
from judge.topics.circles.recipes import whole as circle_whole
from judge.topics.spheres.figures import Case, Scene, lifted, placed, root_off, touch_off, typed
from judge.topics.spheres.hit import Triple

Recipe = Callable[..., Scene]

_STEPS = 6  # bounds the level direction before it is stretched
_BOUND = 1 << 30
_PLANE = {"poses": ("axis",), "centre": 0, "numbers": "int"}  # a level figure stays one of whole numbers


def flat(recipe: Callable[..., Figure], draw: Draw, *, where: Sequence[str], size: int, **pose: Any) -> Scene:
    """A recipe of circles and rays, in space."""
    return placed(draw, lifted(recipe(draw, where=where, size=size, **_PLANE)), **pose)


def grid(draw: Draw, *, size: int) -> Scene:
    """Everything that a small grid holds: coordinates up to ±size, the radius up to size."""
    centre, origin, direction = (_within(draw, size) for _ in range(3))
    return Scene(centre, draw.integer(0, size), origin, direction)


def nothing(draw: Draw, *, where: Sequence[str], size: int, **pose: Any) -> Scene:
    """No ray, D = (0, 0, 0), with the origin on the sphere, inside or outside; or (zero-r) no sphere."""
    kind = draw.choice(where)
    if kind != "zero-r":
        return flat(rays.null_direction, draw, where=[kind], size=size, **pose)
    return flat(rays.point_circle, draw, where=("ahead", "ahead", "off", "at-origin"), size=size, **pose)


def touch_edge(
    draw: Draw,
    *,
    sides: Sequence[str],
    edges: Sequence[str],
    poses: Sequence[str],
    size: int = 1000,
    scales: Sequence[int] = (0,),
    stretch: Sequence[int] = (0, 0),
    ratio: Sequence[int] = (),
    **pose: Any,
) -> Scene:
    """A ray that is, or nearly is, a tangent, its point of contact well ahead, by `ratio` (bounds) radii."""
    radius = draw.integer(max(8, size // 2), size)
    away = {
        "near": draw.integer(radius // 4, radius * 2 // 5),
        "by": draw.integer(radius, 3 * radius),
        "far": draw.integer(radius, 9 * radius) * 10 ** draw.integer(1, 2),
    }[draw.choice(("near", "by", "far"))]
    if ratio:
        away = radius * draw.integer(*ratio)
    level = lifted(ray((0, 0), radius, (-away, radius * draw.sign()), (draw.integer(1, _STEPS), 0)))
    scale, bits = draw.choice(scales), draw.integer(*stretch)
    scene = placed(draw, level, poses=poses, numbers="float", scale=scale, stretch=(bits, bits), **pose)
    return typed(draw, touch_off(draw, scene, _edge(draw, edges), _side(draw, sides, "hit", "miss")), "any")


def origin_edge(
    draw: Draw,
    *,
    sides: Sequence[str],
    edges: Sequence[str],
    poses: Sequence[str],
    size: int = 1000,
    scales: Sequence[int] = (0,),
    stretch: Sequence[int] = (0, 0),
    **pose: Any,
) -> Scene:
    """A ray whose origin is nearly on the sphere, the root "ahead" or "behind"; it looks in or out."""
    radius = draw.integer(max(8, size // 2), size)
    height = draw.integer(-radius * 4 // 5, radius * 4 // 5) if draw.integer(0, 3) else 0
    half = isqrt(radius * radius - height * height) * draw.sign()
    level = lifted(ray((0, 0), radius, (half, height), (draw.integer(1, _STEPS), 0)))
    scale, bits = draw.choice(scales), draw.integer(*stretch)
    scene = placed(draw, level, poses=poses, numbers="float", scale=scale, stretch=(bits, bits), **pose)
    sign = 1 if _side(draw, sides, "ahead", "behind") == "ahead" else -1
    return typed(draw, root_off(draw, scene, _edge(draw, edges), sign), "any")


def whole(draw: Draw, *, kinds: Sequence[str]) -> Scene:
    """Ints up to the bounds: what `kinds` say of a circle and a ray, in a plane across any of the axes."""
    level = lifted(circle_whole.RAYS["whole"](draw, kinds=kinds))
    height = draw.integer(-_BOUND, _BOUND)
    (cx, cy, _), (ox, oy, _) = level.centre, level.origin
    return placed(
        draw, replace(level, centre=(cx, cy, height), origin=(ox, oy, height)), poses=("axis",), centre=0
    )


def anywhere(draw: Draw, *, size: int) -> Scene:
    """A sphere, an origin and a ray to a place within or around the sphere, in whole numbers of any size."""
    centre, origin = _within(draw, size), _within(draw, size)
    radius = draw.integer(size // 8, size // 2)
    target = _within(draw, radius)
    dx, dy, dz = (int(c) + int(x) - int(o) for c, x, o in zip(centre, target, origin, strict=True))
    shorter = draw.integer(2, 9)
    scene = Scene(centre, radius, origin, (dx // shorter, dy // shorter, dz // shorter))
    return typed(draw, scene, "any")


def _within(draw: Draw, size: int) -> Triple:
    return draw.integer(-size, size), draw.integer(-size, size), draw.integer(-size, size)


def _edge(draw: Draw, names: Sequence[str]) -> Edge:
    name = draw.choice(names)
    require(name in EDGES, f"{name!r} is an edge, one of {', '.join(EDGES)}")
    return EDGES[name]


def _side(draw: Draw, sides: Sequence[str], *known: str) -> str:
    side = draw.choice(sides)
    require(side in known, f"{side!r} is a side, one of {', '.join(known)}")
    return side


RECIPES: Mapping[str, Recipe] = {
    "grid": grid,
    "across": partial(flat, rays.across),
    "tangent": partial(flat, rays.tangent),
    "origin-on-sphere": partial(flat, rays.origin_on_circle),
    "nothing": nothing,
    "touch-edge": touch_edge,
    "origin-edge": origin_edge,
    "whole": whole,
    "anywhere": anywhere,
}


def _cased(recipe: Recipe) -> Callable[..., Case]:
    @wraps(recipe)
    def builder(draw: Draw, **parameters: Any) -> Case:
        return recipe(draw, **parameters).case

    return builder


BUILDERS: Mapping[str, Callable[..., Case]] = {name: _cased(recipe) for name, recipe in RECIPES.items()}
