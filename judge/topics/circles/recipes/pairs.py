"""Recipes for two circles: how they lie to one another, and how nearly.

Each draws a figure of the first circle, the second one's centre as a point and its radius as a length. Level
figures have C1 at the origin and C2 on the right; what goes to `posed` is explained there (posing.py).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isqrt, ldexp
from typing import Any

from msgspec.structs import replace

from judge.data.draw import Draw, require
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
from judge.topics.circles.figures.numbers import off_by_one
from judge.topics.circles.figures.posing import posed, small_turn, spun
from judge.topics.circles.pair import CirclePair

_BITS = 64  # of what is computed here below the unit of the figure
_REACH = 1 << 27  # of whole numbers, so that figures fit into the bounds
_BESIDE = ((900, 990), (991, 998))  # thousandths of the distance that a first radius is, next to a small one
_TINY = (9997, 9998)  # ten-thousandths of it that a first radius is, next to the smallest ones that cross
_SPECK = (45, 60)  # octaves below the extent of a radius that drowns in the band
_CLOSE = 1000  # the centres are this part of the extent apart, at least


def pair(draw: Draw, *, kinds: Sequence[str], size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """Two circles that are apart, touch (outer, inner), cross (crossing), or one inside the other (inside);
    about one centre (centre), the same circle (same), equal radii (equal); with a radius of 0 on the other
    circle (on), off it (off), at its centre (middle), or both of them 0 (points, point).
    """
    return posed(draw, _level(draw, draw.choice(kinds), size), poses=poses, **pose)


def grid(draw: Draw, *, size: int) -> Figure:
    """All numbers small integers."""
    first, second = draw_point(draw, size), draw_point(draw, size)
    return Figure(first, draw.integer(0, size), (second,), (), (draw.integer(0, size),))


def anywhere(draw: Draw, *, size: int) -> Figure:
    """Everything anywhere: whole numbers up to the bounds, or small ones that are divided."""
    if draw.boolean():
        return _whole(draw)
    figure = Figure((0, 0), draw.integer(1, size), (draw_point(draw, size),), (), (draw.integer(1, size),))
    return posed(draw, figure, poses=("any",), divisor=draw.integer(1, size))


def edge(
    draw: Draw,
    *,
    kinds: Sequence[str],
    edges: Sequence[str],
    poses: Sequence[str],
    size: int = 1000,
    scales: Sequence[int] = (0,),
    **pose: Any,
) -> Figure:
    """Circles that nearly touch (outer, beside, tiny, inner, around, close) or are nearly the same.

    The second radius is more or less than that of a touch by a share of the extent. A speck is a circle of
    nearly no radius on the other one.
    """
    kind = draw.choice(kinds)
    radius, away = _lengths(draw, kind, draw.integer(max(8, size // 2), size))
    figure = Figure((0, 0), radius, ((away, 0),), (), (radius,))
    figure = posed(draw, figure, poses=poses, numbers="float", scale=draw.choice(scales), **pose)
    name = draw.choice(edges)
    require(name in EDGES, f"{name!r} is an edge, one of {', '.join(EDGES)}")
    if kind == "same":
        figure = _shifted(draw, figure)
    if kind == "speck":
        figure = replace(figure, lengths=(ldexp(float(figure.extent), -draw.integer(*_SPECK)),))
    else:
        figure = _off(draw, figure, EDGES[name], kind)
    if draw.boolean():
        (second,), (length,) = figure.points, figure.lengths
        figure = Figure(second, length, (figure.centre,), (), (figure.radius,))
    return typed(draw, figure, "any")


def whole(draw: Draw) -> Figure:
    """Whole numbers up to the bounds, in ints: as in `anywhere`, or off a touch by one in the squares."""
    if draw.boolean():
        return as_ints(_whole(draw))
    x, y, reach = off_by_one(draw, _REACH, draw.sign())
    if reach < _REACH >> 3:
        draw.reject()  # what is off by one is a touch, by the band of a large figure
    one = draw.integer(reach // 8, reach - 1)
    other = reach - one if draw.boolean() else reach + one
    first = draw_point(draw, _REACH)
    if other > reach and draw.boolean():
        one, other = other, one
    return Figure(first, one, ((first[0] + x, first[1] + y),), (), (other,))


def pair_of(figure: Figure) -> CirclePair:
    """The figure's two circles, in integers."""
    return CirclePair.of(*figure.centre, figure.radius, *figure.points[0], figure.lengths[0])


def _level(draw: Draw, kind: str, size: int) -> Figure:
    one, other = draw.integer(1, size), draw.integer(1, size)
    if kind in ("inner", "inside") and abs(one - other) < 2:
        other = one + draw.integer(2, size)
    least, most = abs(one - other), one + other
    if kind in ("on", "off", "middle"):
        one, other = draw.choice(((0, other), (one, 0)))
    if kind in ("points", "point"):
        one, other = 0, 0
    away = {
        "apart": lambda: draw.integer(most + 1, most + 2 * size),
        "outer": lambda: most,
        "crossing": lambda: draw.integer(least + 1, most - 1),
        "inner": lambda: least,
        "inside": lambda: draw.integer(1, least - 1),
        "on": lambda: max(one, other),
        "off": lambda: draw.choice((max(one, other) + draw.integer(1, size), max(one, other) // 2)),
        "points": lambda: draw.integer(1, size),
    }.get(kind, lambda: 0)()
    if kind == "equal":
        away = draw.integer(1, 4 * one)
    if kind in ("same", "equal"):
        other = one
    elif kind == "centre" and one == other:
        other += draw.integer(1, size)
    if kind == "off" and away == 0:
        away = 3 * size
    # C1 is beside the origin, so that a case is told from the next one.
    figure = moved(Figure((0, 0), one, ((away, 0),), (), (other,)), *draw_point(draw, size))
    require(
        kind in ("same", "centre", "middle", "point") or away > 0, f"{kind!r} is a way for circles to lie"
    )
    return figure


def _lengths(draw: Draw, kind: str, size: int) -> tuple[int, int]:
    """The first radius, and how far away the second centre is."""
    share = draw.integer(50, 950)
    if kind == "outer":
        return max(1, size * share // 1000), size
    if kind == "beside":  # a touch from outside of two circles of which one is very small
        return size * draw.integer(*draw.choice(_BESIDE)) // 1000, size
    if kind == "tiny":
        return size * draw.integer(*_TINY) // 10_000, size
    if kind == "inner":
        return size, max(1, size * share // 1000)
    if kind == "around":  # the second circle is the greater one
        return max(1, size * share // 1000), max(1, size * draw.integer(50, 950) // 1000)
    if kind == "close":
        return size * _CLOSE, max(1, size * draw.integer(1050, 2900) // 1000)
    if kind == "same":
        return size, 0
    require(kind == "speck", f"{kind!r} is an edge of two circles")
    return size, size


def _off(draw: Draw, figure: Figure, edge: Edge, kind: str) -> Figure:
    """The figure with a second radius that is longer or shorter than that of a touch by a share."""
    seen = pair_of(replace(figure, lengths=(0,)))
    radius, away = seen.r1 << _BITS, isqrt(seen.square << 2 * _BITS)
    touch = {
        "outer": away - radius,
        "beside": away - radius,
        "tiny": away - radius,
        "around": radius + away,
        "same": radius,
    }.get(kind, radius - away)
    gap = draw.sign() * max(seen.extent << _BITS, touch) * edge.share(draw) // edge.units
    if touch + gap <= 0:
        draw.reject()
    changed = replace(figure, lengths=((touch + gap) / (1 << (seen.shift + _BITS)),))
    pair = pair_of(changed)
    square, reach = pair.square, pair.reaches[0 if kind in ("outer", "beside", "tiny") else 1]
    if kind == "same":
        square, reach = (pair.r1 - pair.r2) ** 2, 0
    require(
        edge.window.has_share(square, reach, pair.extent),
        "the circles are off by the share that was asked for",
    )
    return changed


def _shifted(draw: Draw, figure: Figure) -> Figure:
    """Circles about one centre, which are perhaps nearly one: it is shifted by some of the band."""
    if draw.boolean():
        return figure
    x, y = figure.centre
    share = EDGES[draw.choice(("snap", "within"))]
    step = float(figure.extent) * share.share(draw) / share.units
    near = (
        (float(x) + draw.sign() * step, float(y))
        if draw.boolean()
        else (float(x), float(y) + draw.sign() * step)
    )
    changed = replace(figure, points=(near,))
    seen = pair_of(changed)
    if not share.window.has_share(seen.square, 0, seen.extent):
        draw.reject()  # the double beside it is too far
    return changed


def _whole(draw: Draw) -> Figure:
    """Whole numbers up to the bounds: touching, or off by 1.01 to 3 times the promise, or crossing anyhow."""
    kind = draw.choice(("crossing", "outer", "inner", "near-outer", "near-inner"))
    size = _REACH >> draw.integer(0, 6)
    one, other = draw.integer(size // 2, size) // 32, draw.integer(size // 2, size) // 64
    away = {"outer": one + other, "inner": one - other}.get(kind.removeprefix("near-"), one)
    if away <= one // 100:
        draw.reject()
    figure = Figure((0, 0), one, ((away, 0),), (), (other,))
    if kind != "crossing":
        figure = spun(figure, small_turn(draw))
    if kind.startswith("near-"):
        gap = draw.sign() * whole_gap(draw, int(figure.extent))
        figure = replace(figure, lengths=(int(figure.lengths[0]) + gap,))
        pair = pair_of(figure)
        reach = pair.reaches[0 if kind == "near-outer" else 1]
        require(EDGES["clear"].window.has_share(pair.square, reach, pair.extent), "they nearly touch")
    x, y = draw_point(draw, _REACH)
    return typed(draw, moved(draw_mirrored(draw, figure), x, y), "any")


RECIPES: Mapping[str, Recipe] = {
    "pair": pair,
    "grid": grid,
    "anywhere": anywhere,
    "pair-edge": edge,
    "whole": whole,
}
