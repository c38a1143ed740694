"""Recipes in whole numbers up to the bounds: products of four of them leave 64 bits, and a double's 53.

Each lays a figure level, turns it by a Pythagorean triple or not at all, and moves it anywhere within the
bounds, all of it in ints. What is nearly so is off by 1.01 to 3 times the promise, in ints as well, and
checked. `kinds` are the figures to choose from.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import isqrt

from judge.data.draw import Draw, require
from judge.topics.circles.figures.edges import EDGES, seen, whole_gap
from judge.topics.circles.figures.figure import Figure, Recipe, draw_mirrored, integer, line, moved, ray
from judge.topics.circles.figures.lines import HIT, MISS, TANGENT, least_gap_at_any_size
from judge.topics.circles.figures.posing import rational_chord, small_turn, spun

BOUND = 1 << 30  # of every number
_OCTAVES = (10, 27)  # of a radius
_STEPS = 1 << 20  # bounds a ray's direction
_PROMISE = EDGES["clear"].window
_BAND = EDGES["snap"].window.high
_HAIR_OCTAVES = (24, 28)  # of a radius, and of all else, where a whole number that is not 0 is in the band


def whole_line(draw: Draw, *, kinds: Sequence[str]) -> Figure:
    """A line that is a tangent, a hit or a miss, or (near-hit, near-miss) nearly a tangent.

    corners: its points are opposite corners of the bounds, so that |B - A|² alone leaves 64 bits;
    within: it is off a tangent by less than the band, but not by nothing.
    """
    kind = draw.choice(kinds)
    if kind == "corners":
        return _corners(draw)
    if kind == "within":
        return _within(draw)
    radius = _radius(draw)
    start, end = _place(draw, radius), _place(draw, radius)
    if start == end:
        draw.reject()
    return _line(draw, kind, radius, lambda height: line((0, 0), radius, (start, height), (end, height)))


def whole_segment(draw: Draw, *, kinds: Sequence[str]) -> Figure:
    """A segment that is a tangent, enters or passes the circle, or (near-hit, near-miss) nearly touches it.

    on: an end is exactly on the circle; stop, pass: an end is nearly on it, the root beyond it or not;
    short: a segment of some millionths of the radius crosses the circle; point: A == B, nearly on it;
    corners: its ends are opposite corners of the bounds, so that |B - A|² alone leaves 64 bits.
    """
    kind = draw.choice(kinds)
    if kind == "corners":
        return _corners(draw)
    if kind in (TANGENT, HIT, MISS, "near-hit", "near-miss"):
        radius = _radius(draw)
        start, end = -draw.integer(1, 3 * radius), draw.integer(1, 3 * radius)
        return _line(draw, kind, radius, lambda height: line((0, 0), radius, (start, height), (end, height)))
    radius, height, half = _chord(draw)
    if kind == "point":
        height, half = 0, radius
    inner, across, outer = half // 2, 2 * half, -2 * half
    places = {
        "on": (0, draw.choice((inner, across, outer))),
        "stop": draw.choice(((-1, outer), (1, inner), (1, across))),
        "pass": draw.choice(((-1, inner), (-1, across), (1, outer))),
        "short": (-1, -half),
        "point": (draw.sign(), -half),
    }
    require(kind in places, f"{kind!r} is a kind of segment")
    sign, other = places[kind]
    past = {"short": draw.integer(1, 30), "point": sign}.get(
        kind, 0
    )  # of the gap, that the other end is moved

    def build(gap: int) -> Figure:
        return line((0, 0), radius, (-half + sign * gap, height), (other + past * gap, height))

    figure = _laid(draw, build, gapped=kind != "on")
    if kind == "point":
        inside = _PROMISE.has_point(seen(figure), "inside")
        require(inside or _PROMISE.has_point(seen(figure), "outside"), "the point is nearly on the circle")
    elif kind != "on":
        beyond = -sign if other > -half or kind == "short" else sign
        require(_PROMISE.has_root(seen(figure), 0, beyond), "an end is nearly on the circle")
        require((beyond < 0) == (kind == "stop"), "the root is on the segment, or not, as asked")
    swap = draw.boolean()
    return line(figure.centre, figure.radius, *figure.points[:: -1 if swap else 1])


def whole_ray(draw: Draw, *, kinds: Sequence[str]) -> Figure:
    """A ray that is a tangent, hits or misses, or (near-hit, near-miss) is nearly a tangent.

    on: its origin is on the circle. inside, past: it is nearly on it and looks in or out, the root just
    behind; ahead, leaving: the same with the root just ahead. within: it is off a tangent by less than the
    band, but not by nothing.
    """
    kind = draw.choice(kinds)
    if kind == "within":
        return _within_ray(draw)
    step = draw.integer(1, draw.choice((1, 9, _STEPS)))
    if kind in (TANGENT, HIT, MISS, "near-hit", "near-miss"):
        radius = _radius(draw)
        start = -draw.integer(radius, 4 * radius)
        return _line(draw, kind, radius, lambda height: ray((0, 0), radius, (start, height), (step, 0)))
    radius, height, half = _chord(draw)
    starts = {
        "on": (-half, 0),
        "inside": (-half, 1),
        "past": (half, 1),
        "ahead": (-half, -1),
        "leaving": (half, -1),
    }
    require(kind in starts, f"{kind!r} is a kind of ray")
    start, sign = starts[kind]

    def build(gap: int) -> Figure:
        return ray((0, 0), radius, (start + sign * gap, height), (step, 0))

    figure = _laid(draw, build, gapped=kind != "on")
    if kind != "on":
        require(_PROMISE.has_root(seen(figure), 0, -sign), "the origin is nearly on the circle")
    return figure


def _corners(draw: Draw) -> Figure:
    """The diagonal from a corner of the bounds to the opposite one, and a circle, missed or cut well."""
    x, y = BOUND * draw.sign(), BOUND * draw.sign()
    half = BOUND // 2
    radius, cx, cy = draw.integer(1 << 20, half), draw.integer(-half, half), draw.integer(-half, half)
    across = abs(cx * y - cy * x) // BOUND  # the distance times the root of 2
    if 9 * radius < 7 * across < 11 * radius:
        draw.reject()  # nearly a tangent, perhaps
    return line((cx, cy), radius, (x, y), (-x, -y))


def _within(draw: Draw) -> Figure:
    """A line with r²a − k² = ±m² for a small m, far off 0 in whole numbers and nothing beside the extent."""
    size = 1 << draw.integer(*_HAIR_OCTAVES)
    figure = draw_mirrored(draw, least_gap_at_any_size(draw, size, draw.choice((HIT, MISS))))
    if figure.radius < 1 << 20:
        draw.reject()
    require(_BAND.touches(seen(figure)), "the line is a tangent by the band")
    return figure


def _within_ray(draw: Draw) -> Figure:
    """A ray along such a line; the point of contact is far from its origin, three times in four ahead."""
    figure = _within(draw)
    line = seen(figure)
    if 100 * abs(line.b) < isqrt(line.a) * line.extent:
        draw.reject()
    sign = (-1 if line.b > 0 else 1) * (1 if draw.integer(0, 3) else -1)
    return ray(figure.centre, integer(figure.radius), figure.points[0], (sign * line.dx, sign * line.dy))


def _line(draw: Draw, kind: str, radius: int, build: Callable[[int], Figure]) -> Figure:
    """The figure of a line at the height that `kind` asks for; `build` makes it of a height."""
    clear = radius // 10
    if kind in (TANGENT, HIT, MISS):
        height = {
            TANGENT: radius,
            HIT: draw.integer(0, radius - clear),
            MISS: draw.integer(radius + clear, 2 * radius),
        }[kind]
        return _laid(draw, lambda _: build(height), gapped=False)
    require(kind in ("near-hit", "near-miss"), f"{kind!r} is a kind of line")
    sign = -1 if kind == "near-hit" else 1
    figure = _laid(draw, lambda gap: build(radius + sign * gap), gapped=True)
    require(_PROMISE.has_tangent(seen(figure), kind.removeprefix("near-")), "the line is nearly a tangent")
    return figure


def _laid(draw: Draw, build: Callable[[int], Figure], *, gapped: bool) -> Figure:
    """The figure that `build` makes of a gap, turned, mirrored and moved within the bounds."""
    turn = small_turn(draw) if draw.boolean() else None
    norm = turn.norm if turn else 1

    def turned(figure: Figure) -> Figure:
        return spun(figure, turn) if turn else figure

    gap = whole_gap(draw, int(turned(build(0)).extent) // norm) if gapped else 0
    figure = draw_mirrored(draw, turned(build(gap)))
    room = BOUND - int(figure.extent)
    if room < 0:
        draw.reject()
    return moved(figure, draw.integer(-room, room), draw.integer(-room, room))


def _radius(draw: Draw) -> int:
    octave = draw.integer(*_OCTAVES)
    return draw.integer(1 << octave, 2 << octave)


def _place(draw: Draw, radius: int) -> int:
    return draw.integer(0, draw.choice((radius // 3, 4 * radius))) * draw.sign()


def _chord(draw: Draw) -> tuple[int, int, int]:
    """A chord with whole ends, as (radius, height, half), of any size."""
    radius, height, half = rational_chord(draw, 60)
    if 5 * abs(height) > 4 * radius:
        draw.reject()
    factor = draw.integer(1 << 10, 1 << draw.integer(12, 24))
    return radius * factor, height * factor, half * factor


LINES: Mapping[str, Recipe] = {"whole": whole_line}
SEGMENTS: Mapping[str, Recipe] = {"whole": whole_segment}
RAYS: Mapping[str, Recipe] = {"whole": whole_ray}
