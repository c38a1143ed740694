"""Recipes for a circle and a closed polygon: which edges cross, where corners are, and how nearly.

Each draws a figure of three points and more, the corners. A level figure has the circle about the origin,
its radius the longest side of a Pythagorean triangle. What goes to `posed` is explained there (posing.py).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from msgspec.structs import replace

from judge.data.draw import Draw, require
from judge.problem.model import Point
from judge.topics.circles.figures.edges import EDGES, root_off, tangent_off
from judge.topics.circles.figures.figure import Figure, Recipe, as_ints, draw_point, typed
from judge.topics.circles.figures.numbers import pythagorean
from judge.topics.circles.figures.posing import posed

_Place = tuple[int, int]

_AROUND: Sequence[_Place] = (  # sixteen directions of about the same length, counter-clockwise
    *((60, 0), (55, 23), (42, 42), (23, 55), (0, 60), (-23, 55), (-42, 42), (-55, 23)),
    *((-60, 0), (-55, -23), (-42, -42), (-23, -55), (0, -60), (23, -55), (42, -42), (55, -23)),
)
_LENGTH = 60
_LARGE = 1 << 22  # what whole figures are enlarged by, at most


def star(
    draw: Draw, *, corners: Sequence[int], poses: Sequence[str], crossed: bool = False, **pose: Any
) -> Figure:
    """Corners inside and outside, all around C; with `crossed` in any order, so that edges cross."""
    h = pythagorean(draw, 40)[2]
    places = _star(draw, h, draw.integer(*corners))
    if crossed:
        places = _shuffled(draw, places)
    return _posed(draw, h, places, poses, pose)


def twice(draw: Draw, *, poses: Sequence[str], **pose: Any) -> Figure:
    """All corners outside, and edges that cut the circle twice."""
    h = pythagorean(draw, 40)[2]
    count = draw.integer(3, 5)
    step = len(_AROUND) // count
    first = draw.integer(0, 15)
    places = [
        _towards(first + step * number + draw.integer(0, 1), h, draw.integer(105, 150))
        for number in range(count)
    ]
    return _posed(draw, h, _started(draw, places), poses, pose)


def corner_on(draw: Draw, *, kinds: Sequence[str], poses: Sequence[str], **pose: Any) -> Figure:
    """Corners exactly on the circle: the boundary passes through there (through), or comes back on the same
    side, from inside (within) or from outside (without); or an edge ends where the next is a chord (chord).
    """
    p, q, h = pythagorean(draw, 40)
    kind = draw.choice(kinds)
    on = draw.choice(((p, q), (q, p), (h, 0)))
    x, y = on
    out = [(2 * x - y, 2 * y + x), (2 * x + y, 2 * y - x)]  # beside the radius, beyond the circle
    within = [(x // 2 - y // 4, y // 2 + x // 4), (x // 2 + y // 4, y // 2 - x // 4)]
    sides = {
        "through": (draw.choice(within), draw.choice(out)),
        "within": (within[0], within[1]),
        "without": (out[0], out[1]),
        "chord": ((-x, y), draw.choice(out)) if x and y else ((0, h), draw.choice(out)),
    }
    require(kind in sides, f"{kind!r} is a kind of corner")
    before, after = sides[kind] if draw.boolean() else sides[kind][::-1]
    rest = [(-3 * h + draw.integer(0, h), draw.integer(-h, h)) for _ in range(draw.integer(0, 2))]
    if kind in ("through", "chord") or not rest:
        rest.append((draw.integer(-3 * h, 3 * h), draw.choice((-3, 3)) * h))
    return _posed(draw, h, _started(draw, [before, on, after, *rest]), poses, pose)


def revisited(draw: Draw, *, poses: Sequence[str], **pose: Any) -> Figure:
    """The boundary comes to one place of the circle twice: at a corner, and at another or within an edge."""
    p, q, h = pythagorean(draw, 40)
    on = draw.choice(((p, q), (q, p), (h, 0)))
    x, y = on
    out = [(2 * x - y, 2 * y + x), (2 * x + y, 2 * y - x)]
    if draw.boolean():
        ahead, aside = x - y // 2, y + x // 2
        second = [(x - ahead, y - aside), (x + ahead, y + aside)]
    else:
        second = [
            on,
            (x // 2 - y // 4, y // 2 + x // 4),
            (-draw.integer(0, h // 2), draw.integer(-h, h) // 2),
        ]
    return _posed(draw, h, _started(draw, [on, *out[:: draw.sign()], *second]), poses, pose)


def closing(draw: Draw, *, poses: Sequence[str], **pose: Any) -> Figure:
    """The edge from the last corner to the first crosses: alone, twice, or once as one of two."""
    h = pythagorean(draw, 40)[2]
    height = draw.integer(1 - h, h - 1)
    far = h + draw.integer(1, 2 * h)
    beyond = [
        (far + draw.integer(0, h), 2 * h + draw.integer(1, h)),
        (-far - draw.integer(1, h), 2 * h + draw.integer(1, h)),
    ]
    if draw.boolean():
        first, last = (far, height), (-far, height + draw.integer(-1, 1))
    else:  # the first corner is inside
        first, last = (draw.integer(-h // 3, h // 3), draw.integer(-h // 3, h // 3)), (-far, height)
    return _posed(draw, h, [first, *beyond[: draw.integer(1, 2)], last], poses, pose)


def touch(draw: Draw, *, poses: Sequence[str], size: int = 0, **pose: Any) -> Figure:
    """An edge that touches, its point within it; the others pass the circle, or two of them cut it."""
    h = draw.integer(size // 2, size) if size else pythagorean(draw, 40)[2]
    reach = draw.integer(h // 4 + 1, 2 * h)
    start, end = (-reach, h), (draw.integer(h // 4 + 1, 2 * h), h)
    low = draw.choice((-1, 1))
    top = [
        (end[0] + draw.integer(0, h), h + low * draw.integer(h, 4 * h)),
        (start[0], h + low * draw.integer(h, 4 * h)),
    ]
    return _posed(draw, h, _started(draw, [start, end, *top[: draw.integer(1, 2)]]), poses, pose)


def apart(draw: Draw, *, kinds: Sequence[str], poses: Sequence[str], **pose: Any) -> Figure:
    """The polygon lies in the circle (inside), around it (around), or beside it (beside)."""
    h = pythagorean(draw, 40)[2]
    if h < 10:
        draw.reject()  # rounded to whole numbers a corner may come to lie on so small a circle
    kind = draw.choice(kinds)
    shares = {"inside": (10, 90), "around": (280, 420), "beside": (20, 90)}  # an edge may be seen under 135°
    require(kind in shares, f"{kind!r} is a place for a polygon")
    count = draw.integer(3, 7)
    first = draw.integer(0, 15)
    turns = [first + len(_AROUND) * number // count for number in range(count)]
    places = [_towards(turn, h, draw.integer(*shares[kind])) for turn in turns]
    if kind == "beside":
        away = draw.integer(2, 3) * h
        places = [(x + away, y) for x, y in places]
    return _posed(draw, h, places, poses, pose)


def grid(draw: Draw, *, size: int) -> Figure:
    """Everything from a small grid: three corners or four, no two neighbours in one place."""
    corners = tuple(draw_point(draw, size) for _ in range(draw.integer(3, 4)))
    if any(one == other for one, other in zip(corners, (*corners[1:], corners[0]), strict=True)):
        draw.reject()
    return Figure(draw_point(draw, size), draw.integer(0, size), corners)


def edge_off(
    draw: Draw,
    *,
    sides: Sequence[str],
    edges: Sequence[str],
    poses: Sequence[str],
    size: int = 20000,
    wide: Sequence[int] = (900, 2000),
    scales: Sequence[int] = (0,),
    ratio: Sequence[int] = (),
    **pose: Any,
) -> Figure:
    """An edge that nearly is a tangent, a "hit" or a "miss", and a third corner inside or far outside.

    One of `wide`, in thousandths of the radius, is how far from the foot its corners are at least. With
    `ratio` (bounds) one corner is so many radii away, straight ahead or across.
    """
    h = draw.integer(size // 2, size)
    far = max(1, h * draw.choice(wide) // 1000)
    start, end = (-far - draw.integer(0, far // 9), h), (far + draw.integer(0, far // 9), h)
    height = draw.choice((h // 4, -h // 4, 5 * h, -4 * h)) + draw.integer(-h // 5, h // 5)
    if ratio:
        away = h * draw.integer(*ratio)
        if draw.boolean():
            end, height = (away, h), -2 * h
        else:
            height = draw.sign() * away
    figure = Figure((0, 0), h, (start, end, (draw.integer(-h // 2, h // 2), height)))
    figure = posed(draw, figure, poses=poses, numbers="float", scale=draw.choice(scales), **pose)
    figure = tangent_off(draw, figure, EDGES[draw.choice(edges)], draw.choice(sides))
    return typed(draw, replace(figure, points=_turned(draw, figure.points)), "any")


def corner_off(
    draw: Draw,
    *,
    sides: Sequence[str],
    edges: Sequence[str],
    poses: Sequence[str],
    size: int = 20000,
    scales: Sequence[int] = (0,),
    ratio: Sequence[int] = (),
    **pose: Any,
) -> Figure:
    """A corner that is nearly on the circle, along both of its edges alike: on the first one, or "beyond" it.

    Both edges go the same way from it, outward or inward, or one of them goes on where the other came from.
    With `ratio` (bounds) the corner across from it is so many radii away, to one side.
    """
    h = draw.integer(size // 2, size)
    ahead, aside = draw.integer(h // 2, 2 * h), draw.integer(1, h // 4)
    way = draw.choice((ahead, -h // 2))
    after = (h + way, aside)
    before = draw.choice(((h + way, -aside), (h + way, -aside), (h - way, aside), (h - way, -aside)))
    rest = (draw.integer(2 * h, 4 * h) * draw.sign(), draw.choice((-3, 3)) * h)
    if draw.boolean():
        rest = (draw.integer(-h // 2, 0), draw.choice((-1, 1)) * h // 3)
    if ratio:
        rest = (draw.integer(-h // 2, 0), draw.sign() * h * draw.integer(*ratio))
    figure = Figure((0, 0), h, ((h, 0), after, rest, before))
    figure = posed(draw, figure, poses=poses, numbers="float", scale=draw.choice(scales), **pose)
    sign = 1 if draw.choice(sides) == "on" else -1
    figure = root_off(draw, figure, EDGES[draw.choice(edges)], 0, sign)
    return typed(draw, replace(figure, points=_turned(draw, figure.points)), "any")


def nearly(draw: Draw, **parameters: Any) -> Figure:
    """One of the two above: a nearly tangent edge, or a corner nearly on the circle."""
    if draw.boolean():
        return edge_off(draw, sides=("hit", "miss"), **parameters)
    return corner_off(draw, sides=("on", "beyond"), **parameters)


def point_circle(draw: Draw, *, poses: Sequence[str], size: int, **pose: Any) -> Figure:
    """A circle that is a point: on an edge, at a corner, inside the polygon, or outside of it."""
    left, right = -draw.integer(1, size), draw.integer(1, size)
    top = (draw.integer(-size, size), draw.choice((-1, 1)) * draw.integer(1, size))
    height = draw.choice((0, 0, 1, -1))
    place = draw.choice((0, 0, left)) if height == 0 else 0
    corners = [(left - place, height), (right - place, height), (top[0] - place, 2 * top[1] + height)]
    return _posed(draw, 0, _started(draw, corners), poses, pose)


def anywhere(draw: Draw, *, size: int, corners: Sequence[int]) -> Figure:
    """Everything anywhere in ±size, in whole numbers or not."""
    count = draw.integer(*corners)
    radius = draw.integer(1, size)
    figure = Figure(draw_point(draw, size), radius, tuple(draw_point(draw, size) for _ in range(count)))
    return typed(draw, figure, "any")


def whole(draw: Draw) -> Figure:
    """Ints up to the bounds: corners on the circle, edges that touch, stars of many corners."""
    kind = draw.choice(("corner", "touch", "star"))
    factor = draw.integer(1 << 10, _LARGE)
    if kind == "corner":
        figure = corner_on(draw, kinds=("through", "within", "without", "chord"), poses=("axis",))
    elif kind == "touch":
        figure = touch(draw, poses=("axis",))
    else:
        figure = star(draw, corners=(10, 40), poses=("axis",))
    figure = as_ints(figure)
    reach = int(figure.extent) * factor
    if reach > 1 << 29:
        draw.reject()
    x, y = draw_point(draw, 1 << 28)
    cx, cy = figure.centre
    corners = tuple((int(px - cx) * factor + x, int(py - cy) * factor + y) for px, py in figure.points)
    return Figure((x, y), int(figure.radius) * factor, corners)


def _star(draw: Draw, h: int, count: int) -> list[_Place]:
    first, place = draw.integer(0, 15), 0
    places = []
    for number in range(count):
        share = draw.integer(30, 85) if draw.boolean() else draw.integer(115, 190)
        places.append(_towards(first + place, h, share))
        place += max(1, (number + 1) * len(_AROUND) // count - number * len(_AROUND) // count)
    return _started(draw, places)


def _towards(number: int, h: int, percent: int) -> _Place:
    x, y = _AROUND[number % len(_AROUND)]
    return (x * h * percent) // (100 * _LENGTH), (y * h * percent) // (100 * _LENGTH)


def _shuffled(draw: Draw, places: Sequence[_Place]) -> list[_Place]:
    rest, found = list(places), []
    while rest:
        found.append(rest.pop(draw.integer(0, len(rest) - 1)))
    return found


def _started(draw: Draw, places: Sequence[_Place]) -> list[_Place]:
    """The same polygon from another corner, perhaps the other way round."""
    at = draw.integer(0, len(places) - 1)
    turned = [*places[at:], *places[:at]]
    return turned[::-1] if draw.boolean() else turned


def _turned(draw: Draw, points: tuple[Point, ...]) -> tuple[Point, ...]:
    at = draw.integer(0, len(points) - 1)
    turned = (*points[at:], *points[:at])
    return turned[::-1] if draw.boolean() else turned


def _posed(
    draw: Draw, radius: int, places: Sequence[_Place], poses: Sequence[str], pose: Mapping[str, Any]
) -> Figure:
    if any(one == other for one, other in zip(places, (*places[1:], places[0]), strict=True)):
        draw.reject()
    return posed(draw, Figure((0, 0), radius, tuple(places)), poses=poses, **pose)


RECIPES: Mapping[str, Recipe] = {
    "star": star,
    "twice": twice,
    "corner-on": corner_on,
    "revisited": revisited,
    "closing": closing,
    "touch": touch,
    "apart": apart,
    "grid": grid,
    "edge-off": edge_off,
    "corner-off": corner_off,
    "nearly": nearly,
    "point-circle": point_circle,
    "anywhere": anywhere,
    "whole": whole,
}
