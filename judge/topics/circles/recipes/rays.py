"""Recipes for a circle and a ray O + t·D: where the origin is, which root comes first, and how nearly.

Each draws a figure of a point O and a vector D. A level ray stands at x = `start` on its line and runs
towards +x, the foot of the perpendicular being x = 0. What goes to `posed` is explained in posing.py.

The parameter is judged by its relative error, so a recipe also keeps it well conditioned
(`well_conditioned`): a program that works carefully in doubles must be able to meet the tolerance.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isqrt, sqrt
from typing import Any

from judge.data.draw import Draw, require
from judge.problem.model import Number, Point
from judge.topics.circles.figures import lines
from judge.topics.circles.figures.figure import (
    Figure,
    Recipe,
    draw_mirrored,
    draw_point,
    integer,
    moved,
    ray,
    scaled,
    typed,
)
from judge.topics.circles.figures.posing import hair, lopsided_tangent, posed, rational_chord, stretched

_CONDITION = 1e5  # how much larger than a rounding error, relatively, the error of a root may come out
_STEPS = 6  # bounds the level direction (length, 0) before it is stretched


def grid(draw: Draw, *, size: int) -> Figure:
    """Everything from a small grid, the null direction included: numbers up to ±size."""
    centre, origin, direction = (draw_point(draw, size) for _ in range(3))
    return ray(centre, draw.integer(0, size), origin, direction)


def uniform(draw: Draw, *, size: int, numbers: str) -> Figure:
    """Centre and origin anywhere in ±size, the direction too, the radius up to size."""
    centre, origin, direction = (draw_point(draw, size) for _ in range(3))
    radius = draw.integer(1, size)
    if direction == (0, 0) or not well_conditioned(*_as_level(centre, radius, origin, direction)):
        draw.reject()
    return typed(draw, ray(centre, radius, origin, direction), numbers)


def across(draw: Draw, *, where: Sequence[str], size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """A line that cuts the circle twice, or passes it clearly; `where` says where the origin stands.

    ahead (the circle is before it: the nearer root), inside (the exit), from-foot (inside, at the foot),
    behind (the circle is behind it: none), beside (the line misses: none).
    """
    radius = draw.integer(2, size)
    kind = draw.choice(where)
    if kind == "beside":
        offset = (radius + draw.integer(1, size)) * draw.sign()
        return _posed(draw, radius, offset, draw.integer(-2 * size, 2 * size), poses=poses, **pose)
    offset = draw.integer(1 - radius, radius - 1)
    inner = isqrt(radius * radius - offset * offset - 1)  # the last place inside the circle
    outer = isqrt(radius * radius - offset * offset) + 1  # the first one outside
    if kind == "ahead":
        start = -outer - draw.integer(0, 2 * size)
    elif kind == "inside":
        start = draw.integer(-inner, inner)
    elif kind == "behind":
        start = outer + draw.integer(0, 2 * size)
    else:
        require(kind == "from-foot", f"{kind!r} is a place for a ray's origin")
        start = 0
    if not well_conditioned(radius, offset, start):
        draw.reject()
    return _posed(draw, radius, offset, start, poses=poses, **pose)


def tangent(draw: Draw, *, where: Sequence[str], size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """A tangent whose one point is ahead of the origin, behind it, or the origin itself."""
    radius = draw.integer(1, size)
    starts = {"ahead": -draw.integer(1, 2 * size), "behind": draw.integer(1, 2 * size), "at-origin": 0}
    kind = draw.choice(where)
    require(kind in starts, f"{kind!r} is a place for a point of contact")
    return _posed(draw, radius, radius * draw.sign(), starts[kind], poses=poses, **pose)


def tangent_off_the_grid(draw: Draw, *, size: int, scale: int, far: int) -> Figure:
    """A tangent ahead of the origin whose point of contact is C ± r·(−q, p)/h, seldom one of the grid.

    The grid's step is 2**scale, and all is moved by up to 2**far: no double there holds that point.
    """
    figure = lines.rational_tangent(draw, size)
    (ax, ay), (bx, by) = ((integer(x), integer(y)) for x, y in figure.points)
    f = ax - integer(figure.centre[0]), ay - integer(figure.centre[1])
    direction = bx - ax, by - ay
    along = f[0] * direction[0] + f[1] * direction[1]
    if 64 * along * along < (direction[0] ** 2 + direction[1] ** 2) * integer(figure.radius) ** 2:
        draw.reject()  # the origin is too near to the point of contact
    if along > 0:
        direction = (-direction[0], -direction[1])
    placed = scaled(draw_mirrored(draw, ray(figure.centre, figure.radius, (ax, ay), direction)), scale)
    dx, dy = (draw.sign() * draw.integer(1 << (far - 1), 1 << far) for _ in range(2))
    return moved(placed, dx, dy)


def near_tangent(
    draw: Draw, *, sides: Sequence[str], size: int, within: bool = False, bits: int = 1, **pose: Any
) -> Figure:
    """A line that cuts ("hit") or misses ("miss") the circle by a `hair`, well ahead of the origin."""
    radius = draw.integer(max(1, size // 4), size)
    start = -draw.integer(radius, 2 * size)
    kind = draw.choice(sides)
    require(kind in ("hit", "miss"), f"{kind!r} is a side of a tangent")
    gap, divisor = hair(draw, radius - start, within=within, bits=bits)
    offset = (radius * divisor + (gap if kind == "miss" else -gap)) * draw.sign()
    honest = within or well_conditioned(radius * divisor, offset, start * divisor)
    require(honest, "a near tangent is met far from the origin")
    return _posed(draw, radius * divisor, offset, start * divisor, divisor=divisor, poses=("any",), **pose)


def origin_on_circle(
    draw: Draw, *, where: Sequence[str], size: int, poses: Sequence[str], **pose: Any
) -> Figure:
    """The origin exactly on the circle (before rounding, in the pose "any"), looking in or out."""
    radius, offset, half = rational_chord(draw, size)
    kind = draw.choice(where)
    require(kind in ("in", "out"), f"{kind!r} is a way to look")
    return _posed(draw, radius, offset, -half if kind == "in" else half, poses=poses, **pose)


def origin_near_circle(
    draw: Draw, *, where: Sequence[str], size: int, within: bool = False, bits: int = 1, **pose: Any
) -> Figure:
    """The origin a `hair` from the circle, measured along the ray.

    past (just outside, looking out), inside (just inside, looking across). So the root nearby is never
    ahead, where it would be too badly conditioned to be asked for.
    """
    radius, offset, half = rational_chord(draw, size)
    if 4 * half < radius:
        draw.reject()
    kind = draw.choice(where)
    require(kind in ("past", "inside"), f"{kind!r} is a place for a ray's origin")
    gap, divisor = hair(draw, radius, within=within, bits=bits)
    start = (half if kind == "past" else -half) * divisor + gap
    return _posed(draw, radius * divisor, offset * divisor, start, divisor=divisor, poses=("any",), **pose)


def near_far_away(
    draw: Draw, *, where: Sequence[str], distance: int, scales: Sequence[int] = (0,), **pose: Any
) -> Figure:
    """A circle of radius 1/2 to 1 up to 2**`distance` away, exactly, that the ray nearly meets.

    miss (a near tangent), past and inside (the origin, as in `origin_near_circle`): off by 4e-7 to 2e-6.
    The whole of it is multiplied by two to one of `scales` at last.
    """
    steps = 24  # a radius in steps of 2**-24 and a place up to 2**28: what a double holds, and no more
    require(distance <= 52 - steps, "the figure's steps are doubles at that distance")
    radius = draw.integer(1 << (steps - 1), 1 << steps)
    gap = draw.integer(radius // 10**6, radius * 2 // 10**6)
    kind = draw.choice(where)
    places = {
        "miss": ((radius + gap) * draw.sign(), -radius),
        "past": (0, radius + gap),
        "inside": (0, gap - radius),
    }
    require(kind in places, f"{kind!r} is a way to nearly meet a circle")
    offset, start = places[kind]
    figure = _posed(
        draw,
        radius,
        offset,
        start,
        poses=("axis",),
        numbers="float",
        centre=0,
        scale=-steps,
        far=distance,
        **pose,
    )
    return scaled(figure, draw.choice(scales))


def null_direction(
    draw: Draw, *, where: Sequence[str], size: int, poses: Sequence[str], **pose: Any
) -> Figure:
    """D = (0, 0), the origin on the circle, inside, outside, or (point) all of a circle of radius 0."""
    radius, offset, half = rational_chord(draw, size)
    radii = {
        "on": radius,
        "inside": radius + draw.integer(1, size),
        "outside": draw.integer(0, radius - 1),
        "point": 0,
    }
    kind = draw.choice(where)
    require(kind in radii, f"{kind!r} is a place for a ray's origin")
    if kind == "point":
        offset = half = 0
    centre = (radius, radius)  # off the origin, so that a case is told from the next one
    origin = (centre[0] + half, centre[1] + offset)
    return posed(draw, Figure(centre, radii[kind], (origin,), ((0, 0),)), poses=poses, **pose)


def point_circle(draw: Draw, *, where: Sequence[str], size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """A circle of radius 0: ahead of the origin, behind it, off the line, or the origin itself."""
    kind = draw.choice(where)
    place = draw.integer(1, size)
    starts = {"ahead": -place, "behind": place, "off": draw.integer(-size, size), "at-origin": 0}
    require(kind in starts, f"{kind!r} is a place for a point")
    return _posed(draw, 0, place if kind == "off" else 0, starts[kind], poses=poses, **pose)


def far_circle(draw: Draw, *, where: Sequence[str], size: int, ratio: Sequence[int], **pose: Any) -> Figure:
    """A circle that is tiny beside its distance from the origin, which is `ratio` (bounds) radii."""
    radius = draw.integer(max(5, size // 2), size)
    distance = radius * draw.integer(*ratio)
    offsets = {
        "tangent": radius,
        "through": draw.integer(0, radius // 2),
        "beside": 2 * radius + draw.integer(0, radius),
    }
    kind = draw.choice(where)
    require(kind in offsets, f"{kind!r} is a way to meet a tiny circle")
    return _posed(draw, radius, offsets[kind] * draw.sign(), -distance, centre=0, **pose)


def lopsided(draw: Draw, *, size: int, ratio: Sequence[int], **pose: Any) -> Figure:
    """A banded tangent along an axis, `ratio` (bounds) radii ahead: one coordinate alone makes the extent."""
    radius, away, changed = lopsided_tangent(draw, size, ratio)
    figure = ray((0, 0), changed, (-away, radius * draw.sign()), (draw.integer(1, _STEPS), 0))
    return posed(draw, figure, poses=("axis",), centre=1, **pose)


def cancellation(draw: Draw, *, size: int, numbers: str, scale: int = 0) -> Figure:
    """A root so near the origin that −b ± √Δ loses its digits: f·f − r² is small, f·D is not. Integers,
    times 2**scale.

    The origin is just outside the circle and looks across it, or just inside and looks out. Only f·f −
    r², which is exact here, knows the root; the chord is long, so that the other root is known well.
    """
    f = draw_point(draw, size)
    square = f[0] ** 2 + f[1] ** 2
    outside = draw.boolean()
    radius = isqrt(square - 1) if outside and square else isqrt(square) + 1
    if radius < size // 2:
        draw.reject()
    power = square - radius * radius
    require(0 < abs(power) <= 2 * radius + 1, "f·f − r² is as small as can be")
    direction = draw_point(draw, size)
    along = f[0] * direction[0] + f[1] * direction[1]
    side = direction[0] * f[1] - direction[1] * f[0]
    if 2 * side * side > radius**2 * (direction[0] ** 2 + direction[1] ** 2) or along == 0:
        draw.reject()
    if (along < 0) != outside:
        direction = (-direction[0], -direction[1])
    centre = draw_point(draw, size)
    origin = (centre[0] + f[0], centre[1] + f[1])
    return typed(draw, scaled(ray(centre, radius, origin, direction), scale), numbers)


def _posed(
    draw: Draw,
    radius: int,
    offset: int,
    start: int,
    *,
    poses: Sequence[str],
    divisor: int = 1,
    stretch: Sequence[int] = (0, 0),
    numbers: str = "any",
    **pose: Any,
) -> Figure:
    """A level ray posed; `stretch` bounds the power of two that D is finally multiplied by, exactly."""
    figure = ray((0, 0), radius, (start, offset), (draw.integer(1, _STEPS) * divisor, 0))
    figure = posed(draw, figure, poses=poses, divisor=divisor, numbers=numbers, **pose)
    return stretched(figure, draw.integer(*stretch))


def well_conditioned(radius: float, offset: float, start: float) -> bool:
    """Whether doubles can know the first root ahead of the origin to a relative 1e-10 or so.

    An error of u·e in the line's distance is one of u·e·r/h in the half-chord h, to be held against the
    root's own distance w from the origin. Where nothing is ahead, nothing is asked. The lengths may be in
    any unit.
    """
    if abs(offset) >= radius:
        return True
    half = sqrt((radius - abs(offset)) * (radius + abs(offset)))
    extent = max(radius, abs(offset) + abs(start))
    ahead = [root for root in (-start - half, -start + half) if root > 0]
    return not ahead or radius * extent <= _CONDITION * half * min(ahead)


def _as_level(centre: Point, radius: Number, origin: Point, direction: Point) -> tuple[float, float, float]:
    """The radius, the offset and the start of the level ray that this one is when turned."""
    fx, fy = origin[0] - centre[0], origin[1] - centre[1]
    dx, dy = direction
    length = sqrt(dx * dx + dy * dy)
    return float(radius), (dx * fy - dy * fx) / length, (dx * fx + dy * fy) / length


RECIPES: Mapping[str, Recipe] = {
    "grid": grid,
    "uniform": uniform,
    "across": across,
    "tangent": tangent,
    "tangent-off-the-grid": tangent_off_the_grid,
    "near-tangent": near_tangent,
    "origin-on-circle": origin_on_circle,
    "origin-near-circle": origin_near_circle,
    "near-far-away": near_far_away,
    "null-direction": null_direction,
    "point-circle": point_circle,
    "far-circle": far_circle,
    "cancellation": cancellation,
    "lopsided": lopsided,
}
