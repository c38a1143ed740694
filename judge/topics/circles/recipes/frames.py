"""Recipes for a circle a frame and a line: (circles, O, D, h), told by where each frame's distance d lies.

    in      d below r(1 − h)          high    d between r and r(1 + h)
    low     d between r(1 − h) and r  out     d above r(1 + h)

A level figure has the line along the x axis and the circles above or below it, in whole numbers with room
between all thresholds. What goes to `posed` is explained in posing.py.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from math import isqrt
from typing import Any

from msgspec.structs import replace

from judge.data.draw import Draw, require
from judge.problem import Case
from judge.problem.model import Number
from judge.topics.circles.figures.edges import EDGES
from judge.topics.circles.figures.figure import Figure, draw_point, typed
from judge.topics.circles.figures.posing import posed
from judge.topics.circles.frames import frames_of, thresholds

PLACES = ("in", "low", "high", "out")
SHARES = (0.01, 0.02, 0.05, 0.1, 0.25)  # what h may be

_STEPS = 6  # bounds the level direction
_BITS = 64  # of what is computed here below the unit of the figure
_POINTS = ("on", "beside")  # where the radius is 0: the centre on the line, which is between the thresholds
_WANDERING = {  # what follows what in a walk: one place further, or the same again
    "in": ("in", "low"),
    "low": ("in", "low", "high"),
    "high": ("low", "high", "out"),
    "out": ("high", "out"),
}
_PATTERNS = {  # how a list of frames goes on after its first one, over and over
    "from-in": ("high", "low", "high", "out", "low", "high"),
    "from-out": ("low", "high", "low", "in", "high", "low"),
}


def walk(draw: Draw, *, frames: Sequence[int], size: int, grows: bool = False, **pose: Any) -> Case:
    """The circle drifts through the line and back, a place at a time; with `grows` its radius changes too."""
    places = [draw.choice(PLACES)]
    for _ in range(draw.integer(*frames) - 1):
        places.append(draw.choice(_WANDERING[places[-1]]))
    return _laid(draw, places, size, grows, pose)


def flicker(draw: Draw, *, frames: Sequence[int], size: int, **pose: Any) -> Case:
    """The circle trembles about a touch: between both thresholds, hardly ever beyond one."""
    places = [draw.choice(("in", "out", "low", "high"))]
    for _ in range(draw.integer(*frames) - 1):
        places.append(draw.choice(("low", "high", "low", "high", "low", "high", "in", "out")))
    return _laid(draw, places, size, False, pose)


def one_sided(draw: Draw, *, frames: Sequence[int], size: int, **pose: Any) -> Case:
    """From a hit beyond r, and from a miss below it, without passing the threshold that counts."""
    kind = draw.choice(tuple(_PATTERNS))
    rest = _PATTERNS[kind]
    places = [kind.removeprefix("from-"), *(rest[at % len(rest)] for at in range(draw.integer(*frames) - 1))]
    return _laid(draw, places, size, False, pose)


def start(draw: Draw, *, frames: Sequence[int], size: int, **pose: Any) -> Case:
    """The first frame is between the thresholds, and so are those after it, for a while or for ever."""
    places = [draw.choice(("low", "low", "high"))]
    for _ in range(draw.integer(*frames) - 1):
        places.append(draw.choice(("low", "high", "low", "high", "low", "high", "in", "out")))
    return _laid(draw, places, size, False, pose)


def edge(
    draw: Draw,
    *,
    frames: Sequence[int],
    edges: Sequence[str],
    poses: Sequence[str],
    size: int = 1000,
    scales: Sequence[int] = (0,),
    ratio: Sequence[int] = (),
    long: int = 0,
    **pose: Any,
) -> Case:
    """Each frame is nearly at the threshold that counts there, on either side, by a share of its extent.

    `edges` names the ranges of shares (those of tangents); the first frame is off a touch by its promise.
    With `ratio` (bounds) the circles are so many radii along the line. With `long` D is up to 2**long times
    as long, by an odd number.
    """
    h = draw.choice(SHARES)
    level = _level(draw, ["in"] * draw.integer(*frames), size, False, h, wide=True, far=ratio)
    scale = draw.choice(scales)
    figure = posed(draw, level, poses=poses, numbers="float", scale=scale, **pose)
    if long:
        times = 2 * draw.integer(1 << long - 2, (1 << long - 1) - 1) + 1
        ((dx, dy),) = figure.vectors
        figure = replace(figure, vectors=((dx * times, dy * times),))
    circles, origin, way = _read(figure)
    shown, made = draw.boolean(), []
    for place, circle in enumerate(circles):
        name = draw.choice([each for each in edges if place or each in ("clear", "beyond")])
        share = Fraction(1) if not place else thresholds(h)[shown]
        below = shown if not place else draw.boolean()
        changed = _at_edge(draw, (circle, origin, way), share, name, below)
        if place and name in ("clear", "beyond"):
            shown = below
        made.append(changed)
    radii = tuple(radius for _, _, radius in made)
    return _case(typed(draw, _with_radii(figure, radii), "any"), h)


def again(draw: Draw, *, frames: Sequence[int], size: int, **pose: Any) -> Case:
    """One circle for each place, and each frame is one of the four: what is shown hangs on the way there."""
    distinct, origin, way, h = _laid(draw, PLACES, size, True, pose)
    place = draw.choice(PLACES)
    picks = [place]
    for _ in range(draw.integer(*frames) - 1):
        place = draw.choice(_WANDERING[place])
        picks.append(place)
    return tuple(distinct[PLACES.index(each)] for each in picks), origin, way, h


def vanishing(draw: Draw, *, frames: Sequence[int], size: int, **pose: Any) -> Case:
    """The circle shrinks to a point now and then, on the line or beside it."""
    places = [draw.choice(("in", "in", "out"))]
    for _ in range(draw.integer(*frames) - 1):
        places.append(draw.choice(("on", "on", "on", "low", "high", "beside", "in")))
    return _laid(draw, places, size, False, pose)


def grid(draw: Draw, *, size: int) -> Case:
    """Everything that a small grid holds: one to six circles, a line in any direction, a wide band."""
    circles = tuple((*draw_point(draw, size), draw.integer(0, size)) for _ in range(draw.integer(1, 6)))
    return circles, draw_point(draw, size), draw_point(draw, size), draw.choice((0.125, 0.25, 0.375, 0.4))


def anywhere(draw: Draw, *, size: int, frames: Sequence[int]) -> Case:
    """Whole numbers up to the bounds: circles off a touch by up to twice the band, on either side."""
    origin, way = draw_point(draw, size // 2), draw_point(draw, size // 1024)
    if way == (0, 0):
        draw.reject()
    h, circles = draw.choice(SHARES), []
    for _ in range(draw.integer(*frames)):
        x, y = draw_point(draw, size // 2)
        cross = way[0] * (origin[1] - y) - way[1] * (origin[0] - x)
        distance = isqrt(cross * cross // (way[0] ** 2 + way[1] ** 2))
        circles.append((x, y, distance * (1000 + draw.integer(-int(2000 * h), int(2000 * h))) // 1000))
    return tuple(circles), origin, way, h


def _laid(draw: Draw, places: Sequence[str], size: int, grows: bool, pose: dict[str, Any]) -> Case:
    h = draw.choice(SHARES)
    options = dict(pose)
    scales = options.pop("scales", (0,))
    figure = posed(draw, _level(draw, places, size, grows, h), scale=draw.choice(scales), **options)
    return _case(figure, h)


def _level(
    draw: Draw,
    places: Sequence[str],
    size: int,
    grows: bool,
    h: float,
    *,
    wide: bool = False,
    far: Sequence[int] = (),
) -> Figure:
    """The circles at their places beside the x axis, each with a distance in whole numbers."""
    require(size * min(SHARES) >= 5, "there is room between the thresholds")
    radius, circles = draw.integer(size, 2 * size), []
    for place in places:
        if grows:
            radius = draw.integer(size, 8 * size)
        along = draw.integer(-3, 3) * radius
        if far:
            along = draw.sign() * radius * draw.integer(*far)
        elif wide and draw.integer(0, 2) == 0:
            along *= 10 ** draw.integer(1, 3)
        off = _distance(draw, place, radius, h) * draw.sign()
        circles.append((along, off, 0 if place in _POINTS else radius))
    (x, y, first), rest = circles[0], circles[1:]
    origin = (draw.integer(-2, 2) * radius, 0)
    way = (draw.integer(1, _STEPS) * draw.sign(), 0)
    points = (origin, *((x, y) for x, y, _ in rest))
    return Figure((x, y), first, points, (way,), tuple(radius for _, _, radius in rest))


def _distance(draw: Draw, place: str, radius: int, h: float) -> int:
    """A distance in whole numbers that is clearly there: a quarter of the band from each threshold."""
    band = int(radius * h)
    room = max(1, band // 4)
    low, high = {
        "in": (0, radius - band - room),
        "low": (radius - band + room, radius - room),
        "high": (radius + room, radius + band - room),
        "out": (radius + band + room, 2 * radius),
        "on": (0, 0),
        "beside": (1, radius),
    }[place]
    if draw.integer(0, 2) and place in ("in", "out"):  # next to the threshold more often than anywhere
        low, high = (high - 2 * band, high) if place == "in" else (low, low + 2 * band)
    return draw.integer(max(0, low), high)


def _at_edge(draw: Draw, case: Any, share: Fraction, name: str, below: bool) -> tuple[Any, Any, float]:
    """The circle with a radius so that d is below `share` of it, or above, by a share of the extent."""
    (x, y, _), origin, way = case
    (frame,) = frames_of([(x, y, 0)], origin, way)
    chosen = EDGES[name]
    distance = isqrt((frame.reach << 2 * _BITS) // (frame.a * frame.a))
    about = distance * share.denominator // share.numerator
    gap = max(about, frame.extent << _BITS) * chosen.share(draw) // chosen.units
    wanted = Fraction(distance + gap if below else distance - gap) / share
    if wanted <= 0:
        draw.reject()
    changed = float(wanted / (1 << frame.shift + _BITS))
    (frame,) = frames_of([(x, y, changed)], origin, way)
    away = frame.gap(share)
    there = away.sign() == (-1 if below else 1)
    require(there and _within(away, chosen.window), "a threshold is off by the share that was asked for")
    return x, y, changed


def _within(away: Any, window: Any) -> bool:
    size = abs(away)
    low, high = (Fraction(width.n, width.m) for width in (window.low, window.high))
    return bool(low <= size) and bool(size <= high)


def _with_radii(figure: Figure, radii: Sequence[float]) -> Figure:
    return Figure(figure.centre, radii[0], figure.points, figure.vectors, tuple(radii[1:]))


def _read(figure: Figure) -> tuple[tuple[tuple[Number, Number, Number], ...], Any, Any]:
    origin, *others = figure.points
    rest = ((*point, radius) for point, radius in zip(others, figure.lengths, strict=True))
    return ((*figure.centre, figure.radius), *rest), origin, figure.vectors[0]


def _case(figure: Figure, h: float) -> Case:
    return (*_read(figure), h)


BUILDERS: Mapping[str, Callable[..., Case]] = {
    "walk": walk,
    "flicker": flicker,
    "one-sided": one_sided,
    "start": start,
    "edge": edge,
    "again": again,
    "vanishing": vanishing,
    "grid": grid,
    "anywhere": anywhere,
}
