"""Recipes for a circle and a segment A→B: which points of the line lie between the ends, and how nearly.

Each draws a figure of two points, A and B. `size` bounds the level figure's numbers before its pose enlarges
or divides them; what goes to `posed` is explained there (posing.py).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isqrt
from typing import Any

from judge.data.draw import Draw, require
from judge.topics.circles.figures.figure import (
    Figure,
    Recipe,
    draw_point,
    line,
    scaled,
    typed,
    with_radius,
)
from judge.topics.circles.figures.numbers import off_by_one
from judge.topics.circles.figures.posing import hair, lopsided_tangent, posed, rational_chord


def grid(draw: Draw, *, size: int) -> Figure:
    """Everything from a small grid, the degenerate included: coordinates up to ±size, radius up to size."""
    centre, a, b = (draw_point(draw, size) for _ in range(3))
    return line(centre, draw.integer(0, size), a, b)


def uniform(draw: Draw, *, size: int, numbers: str) -> Figure:
    """Centre and ends anywhere in ±size, the radius up to size."""
    centre, a, b = (draw_point(draw, size) for _ in range(3))
    return typed(draw, line(centre, draw.integer(1, size), a, b), numbers)


def across(draw: Draw, *, where: Sequence[str], size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """A line that cuts the circle twice, or passes it clearly; `where` says which of it the segment holds.

    through (2 points), entering (1), leaving (1), inside, before, after (none: both roots outside the
    segment), beside (the line misses), from-foot (A is the foot, the second root is on the segment: 1).
    """
    radius = draw.integer(2, size)
    kind = draw.choice(where)
    if kind == "beside":
        offset = (radius + draw.integer(1, size)) * draw.sign()
        start = draw.integer(-2 * size, 2 * size - 1)
        return posed(
            draw, level(radius, offset, start, draw.integer(start + 1, 2 * size)), poses=poses, **pose
        )
    offset = draw.integer(1 - radius, radius - 1)
    inner = isqrt(radius * radius - offset * offset - 1)  # the last place inside the circle
    outer = isqrt(radius * radius - offset * offset) + 1  # the first one outside
    start, end = _places(draw, kind, inner, outer, size)
    figure = level(radius, offset, start, end)
    wanted = {"through": 2, "entering": 1, "leaving": 1, "from-foot": 1}.get(kind, 0)
    require(_crossings(figure) == wanted, f"a segment {kind} the circle meets it {wanted} times")
    return posed(draw, figure, poses=poses, **pose)


def _places(draw: Draw, kind: str, inner: int, outer: int, size: int) -> tuple[int, int]:
    near = outer + draw.integer(0, size)
    if kind == "through":
        return -near, outer + draw.integer(0, size)
    if kind == "entering":
        return -near, draw.integer(-inner, inner)
    if kind == "leaving":
        return draw.integer(-inner, inner), near
    if kind == "from-foot":
        return 0, near
    if kind == "inside":
        if inner == 0:
            draw.reject()
        start = draw.integer(-inner, inner - 1)
        return start, draw.integer(start + 1, inner)
    farther = near + draw.integer(1, size)
    require(kind in ("before", "after"), f"{kind!r} is a place for a segment")
    return (-farther, -near) if kind == "before" else (near, farther)


def tangent(draw: Draw, *, where: Sequence[str], size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """A tangent: its one point is within the segment, at one of its ends, or beyond them."""
    radius = draw.integer(1, size)
    kind = draw.choice(where)
    first, second = draw.integer(1, 2 * size), draw.integer(1, 2 * size)
    require(kind in ("within", "at-end", "beyond"), f"{kind!r} is a place for a point of contact")
    if kind == "within":
        start, end = -first, second
    elif kind == "at-end":
        start, end = draw.choice(((0, second), (-first, 0)))
    else:
        start, end = draw.choice(((first, first + second), (-first - second, -first)))
    return posed(draw, level(radius, radius * draw.sign(), start, end), poses=poses, **pose)


def near_tangent(
    draw: Draw, *, sides: Sequence[str], size: int, within: bool = False, bits: int = 1, **pose: Any
) -> Figure:
    """A line that cuts ("hit") or misses ("miss") the circle by a `hair`, between the segment's ends."""
    radius = draw.integer(max(1, size // 4), size)
    start, end = -draw.integer(radius, 2 * size), draw.integer(radius, 2 * size)
    kind = draw.choice(sides)
    require(kind in ("hit", "miss"), f"{kind!r} is a side of a tangent")
    gap, divisor = hair(draw, max(-start, end) + radius, within=within, bits=bits)
    offset = radius * divisor + (gap if kind == "miss" else -gap)
    figure = level(radius * divisor, offset * draw.sign(), start * divisor, end * divisor)
    require(_crossings(figure) == (2 if kind == "hit" else 0), "a near tangent cuts or misses the circle")
    return posed(draw, figure, poses=("any",), divisor=divisor, **pose)


def end_on_circle(
    draw: Draw, *, where: Sequence[str], size: int, poses: Sequence[str], **pose: Any
) -> Figure:
    """An end exactly on the circle (before rounding, in the pose "any"), the other one wherever `where` says.

    inward (the other end is inside the circle), across (beyond its other side), outward (the segment leaves
    the circle at once), both (it is the whole chord).
    """
    radius, offset, half = rational_chord(draw, size)
    kind = draw.choice(where)
    if kind == "inward":
        if half < 2:
            draw.reject()
        other = draw.integer(1 - half, half - 1)
    else:
        places = {
            "across": half + draw.integer(1, size),
            "outward": -half - draw.integer(1, size),
            "both": half,
        }
        require(kind in places, f"{kind!r} is a place for the other end")
        other = places[kind]
    start, end = (-half, other) if draw.boolean() else (other, -half)
    require(offset**2 + half**2 == radius**2, "an end is on the circle")
    return posed(draw, level(radius, offset, start, end), poses=poses, **pose)


def end_near_circle(
    draw: Draw, *, where: Sequence[str], size: int, within: bool = False, bits: int = 1, **pose: Any
) -> Figure:
    """An end that is a `hair` from the circle, measured along the line.

    short (the segment comes from outside and stops before the circle), touching (it goes on just past
    it), inside (it comes from inside and stops before the circle), out (and goes on just past it).
    """
    radius, offset, half = rational_chord(draw, size)
    if half < 2:
        draw.reject()
    kind = draw.choice(where)
    require(kind in ("short", "touching", "inside", "out"), f"{kind!r} is a place for an end")
    from_inside = kind in ("inside", "out")
    start = draw.integer(1 - half, half - 1) if from_inside else -half - draw.integer(1, size)
    gap, divisor = hair(draw, radius + abs(start), within=within, bits=bits)
    end = (half if from_inside else -half) * divisor + (gap if kind in ("touching", "out") else -gap)
    ends = (start * divisor, end) if draw.boolean() else (end, start * divisor)
    figure = level(radius * divisor, offset * divisor, *ends)
    wanted = 1 if kind in ("touching", "out") else 0
    require(_crossings(figure) == wanted, "an end is just before or just past the circle")
    return posed(draw, figure, poses=("any",), divisor=divisor, **pose)


def end_off_by_one(draw: Draw, *, size: int, numbers: str) -> Figure:
    """Integers with f·f − r² = ±1, f = end − C: the root is within 1 / r of that end, far inside the band.

    Such points are everywhere on a circle (numbers.off_by_one), not only near its axes.
    """
    x, y, radius = off_by_one(draw, size, draw.sign())
    if radius < size // 8:
        draw.reject()  # the band is that of a large circle
    # The other end is straight across the circle or straight outwards, by and large: never along the tangent.
    factor, play = draw.choice((2, -2)), radius // 8
    other = (factor * x + draw.integer(-play, play), factor * y + draw.integer(-play, play))
    ends = ((x, y), other) if draw.boolean() else (other, (x, y))
    return posed(draw, line((0, 0), radius, *ends), poses=("axis",), centre=0, numbers=numbers)


def lopsided(draw: Draw, *, size: int, ratio: Sequence[int], **pose: Any) -> Figure:
    """A banded tangent along an axis, one end `ratio` (bounds) radii away: that coordinate is the extent."""
    radius, away, changed = lopsided_tangent(draw, size, ratio)
    ends = (-draw.integer(1, radius), away)
    figure = level(radius, radius * draw.sign(), *(ends if draw.boolean() else ends[::-1]))
    return posed(draw, with_radius(figure, changed), poses=("axis",), centre=1, **pose)


def point_segment(
    draw: Draw, *, where: Sequence[str], size: int, poses: Sequence[str], **pose: Any
) -> Figure:
    """A segment that is one point, A == B.

    It is on the circle, inside, outside, at the centre, or (point) all of a circle of radius 0.
    """
    radius, offset, half = rational_chord(draw, size)
    kind = draw.choice(where)
    places = {
        "on": (radius, offset, half),
        "inside": (radius + draw.integer(1, size), offset, half),
        "outside": (draw.integer(0, radius - 1), offset, half),
        "centre": (radius, 0, 0),
        "point": (0, 0, 0),
    }
    require(kind in places, f"{kind!r} is a place for a point")
    radius, offset, place = places[kind]
    shift = half + radius  # away from the origin, so that a case is told from the next one
    figure = Figure((shift, 0), radius, ((place + shift, offset), (place + shift, offset)))
    return posed(draw, figure, poses=poses, **pose)


def point_circle(draw: Draw, *, where: Sequence[str], size: int, poses: Sequence[str], **pose: Any) -> Figure:
    """A circle of radius 0: within the segment, at-end, beyond it on its line, or off the line."""
    kind = draw.choice(where)
    first, second = draw.integer(1, size), draw.integer(1, size)
    places = {
        "within": (-first, second),
        "at-end": (0, second),
        "beyond": (first, first + second),
        "off": (-first, second),
    }
    require(kind in places, f"{kind!r} is a place for a point")
    start, end = places[kind] if draw.boolean() else places[kind][::-1]
    return posed(
        draw, level(0, draw.integer(1, size) if kind == "off" else 0, start, end), poses=poses, **pose
    )


def far_circle(draw: Draw, *, where: Sequence[str], size: int, ratio: Sequence[int], **pose: Any) -> Figure:
    """A circle that is tiny beside the segment, one end of which is `ratio` (bounds) radii away."""
    radius = draw.integer(max(5, size // 2), size)
    distance = radius * draw.integer(*ratio)
    kind = draw.choice(where)
    require(kind in ("tangent", "through", "beside"), f"{kind!r} is a way to meet a tiny circle")
    if kind == "tangent":
        offset = radius
    elif kind == "through":
        offset = draw.integer(0, radius // 2)
    else:
        offset = 2 * radius + draw.integer(0, radius)
    close = kind != "tangent" and draw.boolean()
    beyond = 2 * radius + draw.integer(0, radius) if close else distance
    start, end = (-distance, beyond) if draw.boolean() else (beyond, -distance)
    return posed(draw, level(radius, offset * draw.sign(), start, end), centre=0, **pose)


def one_far_end(draw: Draw, *, where: Sequence[str], size: int, ratio: Sequence[int], **pose: Any) -> Figure:
    """One end near a circle that is tiny beside the distance (`ratio` radii, bounds) of the other end.

    The near end (short, touching) or the circle itself (tangent) is off by most of the band: a common point
    by the whole case's extent, but by no length that leaves the far end out of account.
    """
    kind = draw.choice(where)
    require(kind in ("tangent", "short", "touching"), f"{kind!r} is a place for the near end")
    radius, offset, half = rational_chord(draw, size)
    if 5 * abs(offset) > 4 * radius:
        draw.reject()  # the chord shrinks by what the far end's band does to it
    distance = radius * draw.integer(*ratio)
    gap, divisor = hair(draw, distance, within=True, bits=1)
    if kind == "tangent":
        height, near = radius * divisor + gap * draw.sign(), radius * draw.integer(2, 9) * divisor
    else:
        height, near = offset * divisor, half * divisor + (gap if kind == "short" else -gap)
    ends = (near, distance * divisor) if kind != "tangent" else (-near, distance * divisor)
    figure = level(radius * divisor, height * draw.sign(), *(ends if draw.boolean() else ends[::-1]))
    return posed(draw, figure, poses=("any",), divisor=divisor, centre=0, **pose)


def short(draw: Draw, *, where: Sequence[str], size: int, **pose: Any) -> Figure:
    """A segment 1e-5 to 1e-4 radii long that touches (tangent) or crosses the circle, or ends at it.

    A tangent, and the end in short and touching, is off the circle by most of the band, which is far more
    than a hair of the segment's own length.
    """
    kind = draw.choice(where)
    require(kind in ("tangent", "across", "short", "touching"), f"{kind!r} is a place for a short segment")
    radius, offset, half = rational_chord(draw, size)
    if 5 * abs(offset) > 4 * radius:
        draw.reject()
    gap, divisor = hair(draw, radius, within=True, bits=1)
    back, ahead = (radius * draw.integer(10**3, 10**4) * (divisor // 10**8) for _ in range(2))
    if kind == "tangent":
        height = radius * divisor + gap * draw.sign()
        figure = level(radius * divisor, height * draw.sign(), -back, ahead)
    else:
        root = half * divisor * draw.sign()
        start = {"across": root - back, "short": root + gap, "touching": root - gap}[kind]
        end = root + ahead
        if draw.boolean():
            start, end = end, start
        figure = level(radius * divisor, offset * divisor, start, end)
    return posed(draw, figure, poses=("any",), divisor=divisor, **pose)


def point_near_circle(
    draw: Draw, *, sides: Sequence[str], size: int, within: bool = False, bits: int = 1, **pose: Any
) -> Figure:
    """A segment that is one point, A == B, a `hair` inside or outside the circle."""
    radius = draw.integer(max(1, size // 4), size)
    side = draw.choice(sides)
    require(side in ("inside", "outside"), f"{side!r} is a side of the circle")
    gap, divisor = hair(draw, radius + 1, within=within, bits=bits)
    place = radius * divisor + (gap if side == "outside" else -gap)
    return posed(draw, level(radius * divisor, 0, place, place), poses=("any",), divisor=divisor, **pose)


def near_far_away(
    draw: Draw, *, where: Sequence[str], distance: int, scales: Sequence[int] = (0,), **pose: Any
) -> Figure:
    """A circle of radius 1/2 to 1 up to 2**`distance` away, exactly, that the segment nearly meets.

    hit and miss are near tangents, stop and pass near ends, point is A == B; all of them are off by 4e-7 to
    2e-6 of the extent. The whole of it is multiplied by two to one of `scales` at last.
    """
    steps = 24  # a radius in steps of 2**-24 and a place up to 2**28: what a double holds, and no more
    require(distance <= 52 - steps, "the figure's steps are doubles at that distance")
    radius = draw.integer(1 << (steps - 1), 1 << steps)
    gap = draw.integer(radius // 10**6, radius * 2 // 10**6)
    kind = draw.choice(where)
    require(kind in ("hit", "miss", "stop", "pass", "point"), f"{kind!r} is a way to nearly meet a circle")
    start = -radius - draw.integer(1, radius)
    if kind in ("hit", "miss"):
        height, end = (radius - gap if kind == "hit" else radius + gap), -start
    else:
        height, end = 0, -radius + (gap if kind == "pass" else -gap)
        start = end if kind == "point" else start
    ends = (start, end) if draw.boolean() else (end, start)
    figure = level(radius, height * draw.sign(), *ends)
    figure = posed(
        draw, figure, poses=("axis",), numbers="float", centre=0, scale=-steps, far=distance, **pose
    )
    return scaled(figure, draw.choice(scales))


def level(radius: int, offset: int, start: int, end: int) -> Figure:
    """The circle about the origin, and the segment at height `offset` from x = start to x = end."""
    return line((0, 0), radius, (start, offset), (end, offset))


def _crossings(figure: Figure) -> int:
    """How many roots lie strictly between a level figure's ends, for ends that are not on the circle."""
    radius, height = int(figure.radius), int(figure.points[0][1])
    if abs(height) >= radius:
        return 0
    square = radius * radius - height * height
    low, high = sorted(int(x) for x, _ in figure.points)
    first = low < 0 and low * low > square and (high > 0 or high * high < square)
    last = high > 0 and high * high > square and (low < 0 or low * low < square)
    return int(first) + int(last)


RECIPES: Mapping[str, Recipe] = {
    "grid": grid,
    "uniform": uniform,
    "across": across,
    "tangent": tangent,
    "near-tangent": near_tangent,
    "end-on-circle": end_on_circle,
    "end-near-circle": end_near_circle,
    "end-off-by-one": end_off_by_one,
    "point-segment": point_segment,
    "point-circle": point_circle,
    "far-circle": far_circle,
    "one-far-end": one_far_end,
    "short": short,
    "point-near-circle": point_near_circle,
    "near-far-away": near_far_away,
    "lopsided": lopsided,
}
