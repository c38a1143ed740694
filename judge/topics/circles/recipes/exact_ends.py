"""Recipes in whole numbers of any size for a circle and a closed segment: ends on the circle and beside it.

Each draws a figure of two points, A and B, in ints. `size` bounds the radius, by and large; where it is a
list, one of it is drawn. `where` and `kinds` are words, of which one is drawn.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction

from judge.data.draw import Draw, require
from judge.topics.circles.figures import lines
from judge.topics.circles.figures.figure import (
    Figure,
    Recipe,
    draw_mirrored,
    draw_point,
    integer,
    line,
    moved,
    swapped,
)
from judge.topics.circles.figures.lines import HIT, MISS
from judge.topics.circles.figures.numbers import off_by_one, pythagorean

Sizes = int | Fraction | Sequence[int | Fraction]
_OTHERS = ("inward", "across", "outward", "both")  # where the other end is, one being on the circle
_POINTS = ("on", "off", "anywhere", "centre", "point")  # where a segment of one point is
_STEEPEST = 10**6  # of a primitive direction with Δ' = −1: two squares are searched for


def end_on(draw: Draw, *, size: Sizes, where: Sequence[str] = _OTHERS) -> Figure:
    """An end on the circle; the other one inside it, beyond its other side, away from it, or on it too."""
    p, q, h = pythagorean(draw, 60)
    times = draw.integer(1, max(1, _drawn(draw, size) // h))
    on, radius = (p * times, q * times), h * times
    kind = draw.choice(where)
    require(kind in _OTHERS, f"{kind!r} is a place for the other end")
    if kind == "both":
        other = draw.choice(((-on[0], -on[1]), (on[0], -on[1]), (-on[1], on[0]), (radius, 0)))
    else:
        low, high = {"inward": (-9, 9), "across": (-40, -11), "outward": (11, 40)}[kind]
        factor, play = draw.integer(low, high), max(1, radius // 40)
        other = (
            on[0] * factor // 10 + draw.integer(-play, play),
            on[1] * factor // 10 + draw.integer(-play, play),
        )
    if other == on:
        draw.reject()
    return _finished(draw, line((0, 0), radius, on, other), radius)


def end_off(draw: Draw, *, size: Sizes) -> Figure:
    """An end with |A − C|² = r² ± 1: as near to the circle as integers get; the other end in or out of it."""
    x, y, radius = off_by_one(draw, _drawn(draw, size), draw.sign())
    factor, play = draw.choice((0, -2, 2)), max(1, radius // 8)
    other = (factor * x + draw.integer(-play, play), factor * y + draw.integer(-play, play))
    if other == (x, y):
        draw.reject()
    return _finished(draw, line((0, 0), radius, (x, y), other), radius)


def touch(draw: Draw, *, size: Sizes, where: Sequence[str] = ("within", "at-end", "beyond")) -> Figure:
    """A tangent; its point is within the segment, at an end of it (in whole numbers), or beyond them."""
    p, q, h = pythagorean(draw, 60)
    kind = draw.choice(where)
    reach = max(2, _drawn(draw, size) // h)
    if kind == "at-end":
        height = draw.integer(1, reach) * draw.sign()
        figure = lines.laid((0, 0), abs(height) * h, (p, q), height, 0, draw.integer(1, reach) * draw.sign())
        return _finished(draw, figure, reach * h)
    require(kind in ("within", "beyond"), f"{kind!r} is a place for a point of contact")
    radius = draw.integer(1, reach * h)
    f = lines.with_cross((p, q), radius * h * draw.sign())
    figure = _along(draw, lines.placed((0, 0), radius, f, (p, q)), kind, reach)
    require(lines.discriminant(figure) == 0, "Δ' = 0")
    return _finished(draw, figure, radius)


def near_touch(
    draw: Draw, *, size: Sizes, where: Sequence[str] = ("within", "within", "within", "beyond")
) -> Figure:
    """Δ' = ±1, the least integers allow, or ±m² for a small m; the foot on the segment or beyond an end."""
    bound = _drawn(draw, size)
    kind = draw.choice((HIT, MISS))
    if bound > _STEEPEST:
        figure = lines.least_gap_at_any_size(draw, bound, kind)
    else:
        figure = lines.just_hit(draw, bound) if kind == HIT else lines.just_miss(draw, bound)
    gap = lines.discriminant(figure)
    placed = _along(draw, moved(figure, -figure.centre[0], -figure.centre[1]), draw.choice(where))
    require(lines.discriminant(placed) == gap, "a slide along the line leaves Δ' as it is")
    return _finished(draw, placed, bound)


def inside(draw: Draw, *, size: Sizes) -> Figure:
    """Both ends inside the circle, or one of them on it, or just outside of it, beyond the root."""
    p, q, h = pythagorean(draw, 60)
    times = draw.integer(1, max(1, _drawn(draw, size) // h))
    radius = h * times
    ends = [(p * times, q * times)] if not draw.integer(0, 3) else []
    while len(ends) < 2:
        half = radius * 7 // 10  # the square within the circle
        ends.append(draw_point(draw, half))
    if ends[0] == ends[1]:
        draw.reject()
    return _finished(draw, line((0, 0), radius, *ends), radius)


def one_point(draw: Draw, *, size: Sizes, where: Sequence[str] = _POINTS) -> Figure:
    """A == B: on the circle, by 1 in the square beside it, anywhere, at C; all of the circle, or off it."""
    bound = _drawn(draw, size)
    place = draw.choice(where)
    require(place in (*_POINTS, "beside"), f"{place!r} is a place for a point")
    point, radius = draw_point(draw, bound), draw.integer(1, bound)
    if place == "on":
        p, q, h = pythagorean(draw, 60)
        times = draw.integer(1, max(1, bound // h))
        point, radius = (p * times, q * times), h * times
    elif place == "off":
        x, y, radius = off_by_one(draw, bound, draw.sign())
        point = x, y
    elif place in ("centre", "point"):
        point, radius = (0, 0), radius if place == "centre" else 0
    elif place == "beside":
        radius = 0
        if point == (0, 0):
            draw.reject()
    return _finished(draw, line((0, 0), radius, point, point), max(9, bound))


def anywhere(draw: Draw, *, size: Sizes) -> Figure:
    """Everything anywhere, the radius such that about as many segments meet the circle as do not."""
    return lines.scattered(draw, _drawn(draw, size))


def nearly(draw: Draw, *, size: Sizes) -> Figure:
    """Lines of every slope that hit or miss by any part of the radius, around the foot or beyond it."""
    figure = lines.nearly_tangent(draw, _drawn(draw, size), draw.choice((HIT, MISS)))
    where = draw.choice(("within", "within", "beyond"))
    return _finished(draw, _along(draw, moved(figure, -figure.centre[0], -figure.centre[1]), where), 9)


def large(draw: Draw, *, size: Sizes, kinds: Sequence[str]) -> Figure:
    """One of the other recipes, at one of these sizes."""
    bound, kind = _drawn(draw, size), draw.choice(kinds)
    require(kind in _LARGE, f"{kind!r} is a kind of figure")
    return _LARGE[kind](draw, size=bound)


def _along(draw: Draw, figure: Figure, where: str, reach: int = 0) -> Figure:
    """The line of a figure about C = (0, 0): A slid along it by steps of D, and B = A + m·D.

    The foot is from A to B ("within") or not; m is up to `reach`, 1 at least.
    """
    (ax, ay), (bx, by) = figure.points
    f = integer(ax), integer(ay)
    dx, dy = integer(bx) - f[0], integer(by) - f[1]
    steps = -(f[0] * dx + f[1] * dy) // (dx * dx + dy * dy)  # the foot is from here to the next one
    span = draw.integer(1, max(1, reach))
    back = draw.integer(0, span - 1) if where == "within" else -draw.integer(1, max(2, reach))
    start = f[0] + (steps - back) * dx, f[1] + (steps - back) * dy
    return line((0, 0), figure.radius, start, (start[0] + span * dx, start[1] + span * dy))


def _finished(draw: Draw, figure: Figure, reach: int) -> Figure:
    """The figure about C = (0, 0) mirrored, perhaps reversed, and moved by up to `reach`."""
    figure = draw_mirrored(draw, figure)
    if draw.boolean():
        figure = swapped(figure)
    return moved(figure, *draw_point(draw, reach))


def _drawn(draw: Draw, sizes: Sizes) -> int:
    size = draw.choice(sizes) if isinstance(sizes, Sequence) else sizes
    require(size == int(size) and size >= 5, "a size is a whole number, 5 or more")
    return int(size)


_LARGE: Mapping[str, Callable[..., Figure]] = {
    "end-on": end_on,
    "end-off": end_off,
    "touch": touch,
    "near-touch": near_touch,
    "inside": inside,
    "point": one_point,
    "anywhere": anywhere,
}
RECIPES: Mapping[str, Recipe] = {
    "end_on": end_on,
    "end_off": end_off,
    "touch": touch,
    "near_touch": near_touch,
    "inside": inside,
    "one_point": one_point,
    "anywhere": anywhere,
    "nearly": nearly,
    "large": large,
}
