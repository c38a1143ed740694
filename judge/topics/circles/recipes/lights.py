"""Recipes for a ray, the circles around, and a light: whether it reaches the first hit, and what is between.

A figure is that of crowds.py with one point more, the last one, for the light L. A level ray stands at (0, 0)
and runs towards +x. The first circle is the one that is meant to be hit; what comes out is held against the
exact answer, and drawn again where it is another one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import hypot, isqrt
from typing import Any

from msgspec.structs import replace

from judge.data.draw import Draw, require
from judge.topics.circles.bands import Bands
from judge.topics.circles.crowd import Crowd
from judge.topics.circles.figures.edges import EDGES
from judge.topics.circles.figures.figure import (
    Figure,
    Recipe,
    as_ints,
    draw_mirrored,
    draw_point,
    moved,
    typed,
)
from judge.topics.circles.figures.posing import posed, rational_chord, small_turn, spun, stretched
from judge.topics.circles.recipes.crowds import LevelCircle, circles_of, level_figure
from judge.topics.circles.shadow import Shade, shade_of

Spot = tuple[int, int]

_BANDS = Bands(Fraction(0), Fraction(1, 10**7))
_GRAZE, _LEAST = Fraction(1, 10**6), Fraction(1, 10**4)
_REACH = 1 << 26
_KINDS = {  # what the light is to the point that is hit
    "open": Shade.LIT,
    "room": Shade.LIT,
    "back": Shade.BACK,
    "wall": Shade.OWN,
    "level-wall": Shade.OWN,
    "blocked": Shade.BLOCKED,
    "gap": Shade.BLOCKED,
    "around-light": Shade.BLOCKED,
    "around-point": Shade.BLOCKED,
    "skin": Shade.BLOCKED,
    "pillar": Shade.BLOCKED,
    "moat": Shade.BLOCKED,
    "court": Shade.LIT,
    "outdoors": Shade.BACK,
    "level-open": Shade.LIT,
    "level-back": Shade.BACK,
    "beyond": Shade.LIT,
    "behind": Shade.LIT,
    "miss": Shade.NOTHING,
}


def lamp(
    draw: Draw,
    *,
    kinds: Sequence[str],
    size: int,
    poses: Sequence[str],
    others: Sequence[int] = (0, 2),
    scales: Sequence[int] = (0,),
    stretch: Sequence[int] = (0, 0),
    whole: bool = False,
    **pose: Any,
) -> Figure:
    """A light that shines freely (open), from within the room of the circle (room), on the other side (back),
    through the circle's own wall (wall); one that is blocked by a circle or by a tiny one close to the point
    (gap), by one that holds the light (around-light) or the way to the point (around-point), perhaps just so
    (skin); by the smaller (pillar) or the larger (moat) of two circles about one centre, or not by one that
    holds everything (court); one outside of the room, close to the wall that is hit (outdoors); one that is
    nearly level with the surface, above it (level-open), below it (level-back) or, from within the room,
    through the wall right beside the point (level-wall); one with a circle beyond it, or behind the point
    (behind). Of miss nothing is hit.

    `others` bounds how many circles stand about, `stretch` the power of two that D is multiplied by, exactly.
    With `whole` all is in ints, up to the bounds.
    """
    kind = draw.choice(kinds)
    require(kind in _KINDS, f"{kind!r} is a way for a light to shine")
    circles, light = _laid(draw, kind, size)
    circles += [_about(draw, size) for _ in range(draw.integer(*others))]
    order = draw.choice((circles, circles[::-1], circles[1:] + circles[:1]))
    figure = level_figure(draw, order, 1, light, shuffled=False)
    if whole:
        figure = _in_ints(draw, figure)
    else:
        figure = posed(draw, figure, poses=poses, scale=draw.choice(scales), **pose)
        figure = stretched(figure, draw.integer(*stretch))
    if _shade(figure) is not _KINDS[kind]:
        draw.reject()
    return figure


def anywhere(
    draw: Draw, *, size: int, count: Sequence[int], numbers: str = "any", shades: Sequence[str] = ()
) -> Figure:
    """Circles, the ray and the light anywhere in ±size; with `shades` the light is one of these."""
    least, most = max(1, size // 60), max(2, size // 8)
    circles = [(*draw_point(draw, size), draw.integer(least, most)) for _ in range(draw.integer(*count))]
    figure = level_figure(draw, circles, 1, draw_point(draw, size))
    direction = draw_point(draw, size)
    if direction == (0, 0):
        draw.reject()
    figure = replace(figure, centre=draw_point(draw, size), vectors=(direction,))
    if shades and _shade(figure) is not Shade(draw.choice(shades)):
        draw.reject()
    return typed(draw, figure, numbers)


def close(
    draw: Draw,
    *,
    size: int,
    poses: Sequence[str],
    edges: Sequence[str],
    scales: Sequence[int] = (0,),
    apart: Sequence[int] = (),
    **pose: Any,
) -> Figure:
    """A circle beside the way to the light, which nearly touches it, on either side.

    With `apart` (bounds) its centre is so many sizes farther from the way.
    """
    circles, light = _laid(draw, "blocked", size)
    if apart:
        circles[1] = _beside(draw, circles, light, size * draw.integer(*apart))
    figure = level_figure(draw, circles[::-1], 1, light, shuffled=False)
    figure = posed(draw, figure, poses=poses, numbers="float", scale=draw.choice(scales), **pose)
    edge = EDGES[draw.choice(edges)]
    share = edge.share(draw) / edge.units * draw.sign()
    (x, y), end = figure.points[0], figure.points[-1]
    px, py = _first(figure)
    vx, vy = end[0] - px, end[1] - py
    away = abs(vx * (y - py) - vy * (x - px)) / hypot(vx, vy)
    radius = away + share * float(figure.extent)
    if radius <= 0:
        draw.reject()
    figure = replace(figure, radius=radius)
    if _shade(figure) not in (Shade.LIT, Shade.BLOCKED):
        draw.reject()
    return typed(draw, figure, "any")


def _beside(draw: Draw, circles: Sequence[LevelCircle], light: Spot, away: int) -> LevelCircle:
    """The second circle, moved so far across the way from the point where the ray meets the first."""
    (cx, cy, r), (x, y, radius) = circles
    vx, vy = light[0] - cx + isqrt(r * r - cy * cy), light[1]
    length = max(1, isqrt(vx * vx + vy * vy))
    away *= draw.sign()
    return x - away * vy // length, y + away * vx // length, radius


def _shade(figure: Figure) -> Shade | None:
    """The exact answer; None where it is nearly another one."""
    *_, light = figure.points
    crowd = Crowd.of(circles_of(figure), figure.centre, figure.vectors[0], light)
    shade, broken = shade_of(crowd, _BANDS, _GRAZE, _LEAST)
    return None if broken else shade


def _first(figure: Figure) -> tuple[float, float]:
    """The point of the last circle that the ray comes to first, in doubles."""
    *_, (cx, cy, r) = circles_of(figure)
    (ox, oy), (dx, dy) = figure.centre, figure.vectors[0]
    length = hypot(dx, dy)
    ux, uy = dx / length, dy / length
    fx, fy = ox - cx, oy - cy
    k, m = ux * fy - uy * fx, fx * ux + fy * uy
    t = -m - max(0.0, float((r - k) * (r + k))) ** 0.5
    return ox + t * ux, oy + t * uy


def _laid(draw: Draw, kind: str, size: int) -> tuple[list[LevelCircle], Spot]:
    """The circle that is hit and perhaps one between, and the light."""
    if kind == "miss":
        radius = draw.integer(size // 4, size)
        height = (radius + draw.integer(1, size)) * draw.sign()
        return [(draw.integer(-size, 2 * size), height, radius)], draw_point(draw, 2 * size)
    radius, offset, half = rational_chord(draw, size)
    if draw.boolean():  # the point that is hit is no grid's
        radius = draw.integer(2, size)
        offset = draw.integer(1 - radius, radius - 1)
        half = isqrt(radius * radius - offset * offset)
    if kind in ("room", "wall", "outdoors", "level-wall"):
        # The ray begins inside, `back` behind the wall that it hits.
        back = draw.integer(1, max(1, 2 * half - 1))
        circle = back - half, offset, radius
        if kind == "level-wall":
            along = draw.integer(2, 4) * draw.sign()
            return [circle], (back + along * offset - draw.integer(1, 9), along * half)
        reach = radius if kind == "room" else 3 * size
        return [circle], (circle[0] + draw.integer(-reach, reach), circle[1] + draw.integer(-reach, reach))
    if kind == "pillar":
        x = draw.integer(1, max(1, 2 * half - 1)) - half
        share = draw.integer(20, 90)
        light = x - half * share // 100, offset + offset * share // 100
        return [(x, offset, radius), (x, offset, draw.integer(1, max(1, abs(offset) - 1)))], light
    at = draw.integer(1, 2 * size)
    circle = at + half, offset, radius
    if kind == "moat":
        wall = isqrt(circle[0] ** 2 + offset**2) + draw.integer(2, size)
        return [circle, (*circle[:2], wall)], (-draw.integer(0, 9 * size), draw.integer(-9 * size, 9 * size))
    light = at + draw.integer(-2 * size, size), draw.integer(-2 * size, 2 * size)
    if kind in ("open", "back"):
        return [circle], light
    if kind == "court":
        about = draw.choice((circle[:2], draw_point(draw, size)))
        return [circle, (*about, draw.integer(7 * size, 9 * size))], light
    if kind in ("level-open", "level-back"):
        along, inward = draw.integer(2, 4) * draw.sign(), 1 if kind == "level-back" else -1
        up = (offset > 0) - (offset < 0)
        return [circle], (at + along * offset + inward, -along * half + inward * up)
    if kind == "skin":
        gap = draw.integer(1, 6)
        return [circle, (gap, 0, at)], (at + draw.integer(1, 2 * size), light[1])
    if kind == "around-point":
        around = max(2, at * draw.integer(60, 90) // 100)
        return [circle, (at // 2, draw.integer(-at // 8, at // 8), around)], light
    return [circle, _between(draw, kind, (at, 0), light, size)], light


def _between(draw: Draw, kind: str, point: Spot, light: Spot, size: int) -> LevelCircle:
    """A circle that the line from the point to the light runs through: between them, beyond or behind."""
    way = light[0] - point[0], light[1] - point[1]
    length = max(1, isqrt(way[0] ** 2 + way[1] ** 2))
    if kind == "gap":
        radius, along = max(2, size // 300), 4 * max(2, size // 300)
    else:
        radius = max(2, length // draw.integer(5, 12))
        share = {
            "blocked": (25, 75),
            "beyond": (130, 250),
            "behind": (-150, -30),
            "around-light": (100, 100),
        }[kind]
        along = length * draw.integer(*share) // 100
    aside = draw.integer(-radius // 2, radius // 2)
    x = point[0] + (way[0] * along - way[1] * aside) // length
    y = point[1] + (way[1] * along + way[0] * aside) // length
    return x, y, radius


def _about(draw: Draw, size: int) -> LevelCircle:
    """A circle somewhere about, seldom in the way."""
    x, y = draw.integer(-3 * size, 3 * size), draw.sign() * draw.integer(0, 3 * size)
    return x, y, draw.integer(max(1, size // 20), max(2, size // 3))


def _in_ints(draw: Draw, figure: Figure) -> Figure:
    figure = spun(figure, small_turn(draw))
    reach = max(1, _REACH - int(figure.extent))
    return as_ints(moved(draw_mirrored(draw, figure), *draw_point(draw, reach)))


RECIPES: Mapping[str, Recipe] = {"lamp": lamp, "anywhere": anywhere, "close": close}
