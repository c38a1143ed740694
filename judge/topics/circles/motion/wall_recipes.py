"""Recipes for a moving disc and a wall: where they touch, and how nearly.

Each draws a figure of P0 and r, and the points P1, A and B. The level wall goes from the origin to the right.
A touch is laid out first, the place of P and what leads away from
the wall; the way goes through it. What goes to `posed` is explained in posing.py.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import isqrt
from typing import Any

from msgspec.structs import replace

from judge.data.draw import Draw, require
from judge.problem import Case
from judge.topics.circles.figures.edges import EDGES, Edge, whole_gap
from judge.topics.circles.figures.figure import (
    Figure,
    Recipe,
    as_ints,
    draw_mirrored,
    draw_point,
    moved,
    typed,
)
from judge.topics.circles.figures.numbers import pythagorean
from judge.topics.circles.figures.posing import posed, small_turn, spun
from judge.topics.circles.motion.ball_recipes import BANDS
from judge.topics.circles.motion.wall import Wall, Widths
from judge.topics.circles.plane import IntPoint

WIDTHS = Widths(Fraction(1, 10**6), Fraction(1, 10**3), Fraction(1, 10**4), Fraction(1, 10**4))
_BITS = 64  # of what is computed here below the unit of the figure
_REACH = 1 << 27  # of whole numbers, so that figures fit into the bounds
_STEPS = 12  # bounds a way's direction, in both coordinates
_FAST = (20, 400)
_FLAT = (100, 9900)  # how far a disc goes along the wall while it nears it by 1
_SPANS = ((1, 9, 1), (1, 9, 1), (9, 40, 1), (0, 1, 1), (1, 0, 1), (0, 0, 9))
_FACTOR = 8  # bounds how much larger than the smallest triple a disc is

_Touch = tuple[IntPoint, IntPoint, int, int]  # where P is, away from the wall, the radius, the wall's length


def wall_case(figure: Figure) -> Case:
    """The arguments P0, P1, r, A, B."""
    p1, a, b = figure.points
    return (figure.centre, p1, figure.radius, a, b)


def wall_of(figure: Figure) -> Wall:
    """The figure's disc and wall in integers."""
    return Wall.of(*wall_case(figure))


def wall(
    draw: Draw,
    *,
    kinds: Sequence[str],
    at: Sequence[str],
    size: int,
    poses: Sequence[str],
    scales: Sequence[int] = (0,),
    ratio: Sequence[int] = _FAST,
    broad: Sequence[int] = (),
    **pose: Any,
) -> Figure:
    """A disc that hits the wall (hit, straight, flat, fast), stops before it (short), leaves it (away), or
    rests apart from it (rest); that overlaps it from the start (overlap), also at rest (still), or touches it
    there (touching); that grazes it (graze), would do so later (graze-late) or would have done so before
    (graze-behind); that slides along it (slide); or that passes beside it and would hit its line (beside).

    `at` is where that happens: at a side, at a cap around an end, or at a post, a wall that is a point. A
    fast disc goes as many steps of its way before and after as `ratio` bounds. With `broad` the radius of one
    that touches a side is so many times the wall's length.
    """
    kind, place = draw.choice(kinds), draw.choice(at)
    touch = _touch(draw, place, size, broad)
    start, end = _way(draw, kind, touch, ratio)
    _, _, radius, length = touch
    ends = ((0, 0), (length, 0))
    figure = Figure(start, radius, (end, *(ends if draw.boolean() else ends[::-1])))
    # The wall is beside the origin, so that a case is told from the next one.
    figure = moved(figure, *draw_point(draw, size))
    return _kept(draw, posed(draw, figure, poses=poses, scale=draw.choice(scales), **pose))


def grid(draw: Draw, *, size: int) -> Figure:
    """All numbers small integers."""
    start, *points = (draw_point(draw, size) for _ in range(4))
    return _kept(draw, Figure(start, draw.integer(0, size), tuple(points)))


def edge(
    draw: Draw,
    *,
    kinds: Sequence[str],
    edges: Sequence[str],
    at: Sequence[str],
    poses: Sequence[str],
    size: int = 200,
    scales: Sequence[int] = (0,),
    spans: Sequence[Sequence[int]] = _SPANS,
    **pose: Any,
) -> Figure:
    """A disc that nearly grazes an end (graze), nearly touches at the start (start), at the end of its way
    (end) or all the time (rest): r is more or less than that takes by a share of the extent.

    The way before and after the touch is so many steps as one of `spans` says, to ten times as many; its last
    number is how many times longer than this the wall is, but for 1.
    """
    kind, name = draw.choice(kinds), draw.choice(edges)
    require(name in EDGES, f"{name!r} is an edge, one of {', '.join(EDGES)}")
    require(kind in ("graze", "start", "end", "rest"), f"{kind!r} is an edge of a disc and a wall")
    place = draw.choice(at)
    if kind == "graze" and place == "side":
        place = "cap"
    spot, away, radius, length = _touch(draw, place, size)
    if kind == "graze":
        direction = _across(away)
    else:  # straight on, or at any angle
        direction = (-away[0], -away[1]) if draw.integer(0, 3) == 0 else _inwards(draw, away)
    before, after, longer = draw.choice(spans)
    first, last = draw.integer(before, 9 * before + 1), draw.integer(after, 9 * after + 1)
    if kind == "start":
        first, last = 0, (last or 1) * draw.sign()
    elif kind == "end":
        first, last = first or 1, 0
    elif kind == "rest":
        first = last = 0
    elif first + last == 0:
        draw.reject()
    if longer > 1:
        length = longer * max(1, first + last) * max(map(abs, direction))
    start, end = _step(spot, direction, -first), _step(spot, direction, last)
    ends = ((0, 0), (length, 0))
    figure = Figure(start, radius, (end, *(ends if draw.boolean() else ends[::-1])))
    figure = moved(figure, *draw_point(draw, size))
    figure = posed(draw, figure, poses=poses, numbers="float", scale=draw.choice(scales), **pose)
    figure = _off(draw, figure, EDGES[name], kind)
    return typed(draw, _kept(draw, figure), "any")


def anywhere(draw: Draw, *, size: int) -> Figure:
    """Everything anywhere: whole numbers up to the bounds, or small ones that are divided."""
    if draw.boolean():
        return _whole(draw)
    start, *points = (draw_point(draw, size) for _ in range(4))
    figure = Figure(start, draw.integer(1, size), tuple(points))
    return _kept(draw, posed(draw, figure, poses=("any",), divisor=draw.integer(1, size)))


def whole(draw: Draw) -> Figure:
    """Whole numbers up to the bounds, in ints."""
    return as_ints(_whole(draw))


def _touch(draw: Draw, place: str, size: int, broad: Sequence[int] = ()) -> _Touch:
    """A disc that touches the level wall from above or before its first end."""
    if place == "side":
        radius, length = draw.integer(1, size), draw.integer(1, 3 * size)
        if broad:
            radius = length * draw.integer(*broad)
        foot = 0 if draw.integer(0, 5) == 0 else draw.integer(0, length)  # at 0 side and cap meet
        return (foot, radius), (0, 1), radius, length
    require(place in ("cap", "post"), f"{place!r} is a part of a wall")
    p, q, h = pythagorean(draw, max(5, size // _FACTOR)) if draw.integer(0, 3) else (1, 0, 1)
    times = draw.integer(1, max(1, size // h))
    length = 0 if place == "post" else draw.integer(1, 3 * size)
    away = -p, q * draw.sign()
    return (away[0] * times, away[1] * times), away, h * times, length


def _way(draw: Draw, kind: str, touch: _Touch, ratio: Sequence[int]) -> tuple[IntPoint, IntPoint]:
    """Where P starts and ends, for what is to happen at the touch."""
    spot, away, radius, length = touch
    if kind.startswith("graze"):
        direction = _across(away)
        if not away[0]:
            draw.reject()  # along the side: that is a slide
    elif kind == "straight":
        direction = -away[0], -away[1]
    elif kind == "flat":
        direction = draw.sign() * draw.integer(*_FLAT), -1
    else:
        direction = _inwards(draw, away)
    near, far = draw.integer(1, 9), draw.integer(1, 9)
    if kind in ("hit", "straight", "flat", "graze"):
        return _step(spot, direction, -near), _step(spot, direction, far if kind != "graze" else far - 1)
    if kind == "fast":
        times = draw.integer(*ratio), draw.integer(*ratio)
        steps = [max(1, count * radius // max(map(abs, direction))) for count in times]
        return _step(spot, direction, -steps[0]), _step(spot, direction, steps[1])
    if kind in ("short", "graze-late"):
        return _step(spot, direction, -near - far), _step(spot, direction, -near)
    if kind in ("away", "graze-behind"):
        sign = 1 if kind == "graze-behind" else -1
        return _step(spot, direction, sign * near), _step(spot, direction, sign * (near + far))
    if kind == "rest":
        start = _step(spot, direction, -near)
        return start, start
    if kind == "touching":
        return spot, _step(spot, direction, far * draw.sign())
    if kind in ("overlap", "still"):
        start = draw.integer(0, length), draw.integer(1 - radius, radius - 1)
        return start, start if kind == "still" else _step(start, direction, draw.integer(-far, far))
    if kind == "slide":
        start, end = (-near * radius, radius), (draw.integer(0, length + radius), radius)
        return start, end
    require(kind == "beside", f"{kind!r} is something that a disc does with a wall")
    beyond = length + radius + draw.integer(1, 9 * radius + 9)
    run, rise = draw.integer(0, radius), draw.integer(radius + 1, 9 * radius + 9)
    return (beyond + run, rise), (beyond, -draw.integer(0, rise))


def _inwards(draw: Draw, away: IntPoint) -> IntPoint:
    """A direction towards the wall, at any angle but along it."""
    x, y = draw_point(draw, _STEPS)
    towards = x * away[0] + y * away[1]
    if not towards:
        draw.reject()
    return (x, y) if towards < 0 else (-x, -y)


def _across(away: IntPoint) -> IntPoint:
    return -away[1], away[0]


def _step(place: IntPoint, direction: IntPoint, steps: int) -> IntPoint:
    return place[0] + direction[0] * steps, place[1] + direction[1] * steps


def _off(draw: Draw, figure: Figure, edge: Edge, kind: str) -> Figure:
    """The figure with a radius that is off by a share of the extent."""
    seen = wall_of(replace(figure, radius=0))
    share = edge.share(draw) * draw.sign()
    if kind == "end":
        return _ending(draw, figure, seen, edge, share)
    square = seen.least if kind == "graze" else seen.start
    touch = isqrt((square.numerator << 2 * _BITS) // square.denominator)
    gap = max(seen.extent << _BITS, touch) * share // edge.units
    changed = _reaching(draw, figure, touch + gap, seen)
    after = wall_of(changed)
    fits = edge.window.has_share(*after.scaled(after.least if kind == "graze" else after.start))
    require(fits, "disc and wall are off by the share that was asked for")
    return changed


def _ending(draw: Draw, figure: Figure, seen: Wall, edge: Edge, share: int) -> Figure:
    """The figure with a radius that touches the wall a share of the extent before the end, or after it."""
    back = Fraction(share * seen.extent, edge.units * seen.pace.step)
    square = seen.apart(1 - back)
    changed = _reaching(draw, figure, isqrt((square.numerator << 2 * _BITS) // square.denominator), seen)
    after = wall_of(changed)
    first = after.first(BANDS)
    if first is None:
        draw.reject()
    low, high = (Fraction(width.n, width.m) for width in (edge.window.low, edge.window.high))
    if not after.pace.close(first, 1, high) or after.pace.close(first, 1, low, strictly=True):
        draw.reject()  # the way is too oblique for a radius that is a double
    return changed


def _reaching(draw: Draw, figure: Figure, radius: int, seen: Wall) -> Figure:
    if radius <= 0:
        draw.reject()
    return replace(figure, radius=radius / (1 << (seen.caps[0].shift + _BITS)))


def _kept(draw: Draw, figure: Figure) -> Figure:
    """The figure, unless it breaks the promise."""
    if wall_of(figure).broken(BANDS, WIDTHS):
        draw.reject()
    return figure


def _whole(draw: Draw) -> Figure:
    """Whole numbers up to the bounds: a graze, nearly one, a touch, or anything."""
    kind = draw.choice(("any", "graze", "near", "hit"))
    if kind == "any":
        first, *others = (draw_point(draw, _REACH) for _ in range(4))
        radius = draw.integer(1, _REACH >> draw.integer(0, 9))
        return typed(draw, _kept(draw, Figure(first, radius, tuple(others))), "any")
    size = _REACH // 64 >> draw.integer(0, 3)
    radius, length = draw.integer(size // 4, size), draw.integer(size // 4, size)
    rise = draw.integer(size, 2 * size)
    start = -radius, rise
    end = -radius if kind != "hit" else draw.integer(0, length), -draw.integer(size, 2 * size)
    figure = spun(Figure(start, radius, (end, (0, 0), (length, 0))), small_turn(draw))
    if kind == "near":
        gap = draw.sign() * whole_gap(draw, int(wall_of(figure).extent))
        figure = replace(figure, radius=int(figure.radius) + gap)
    figure = moved(draw_mirrored(draw, figure), *draw_point(draw, _REACH))
    return typed(draw, _kept(draw, figure), "any")


WALLS: Mapping[str, Recipe] = {
    "wall": wall,
    "grid": grid,
    "wall-edge": edge,
    "anywhere": anywhere,
    "whole": whole,
}
