"""Where answers about a circle and a line turn: nine figures each, to measure a threshold in.

The figures differ in size, in the radius, in the length of A→B or of D, in direction and in their offset from
the origin, one of them at a time, so that nine thresholds tell what a threshold follows. All their lengths
are small multiples of a power of two along a direction of Pythagorean numbers (p, q, h): the distance at
which the answer turns is a double, and so is every coordinate. The radius is what moves (of
`no line` the end B, or D): the gap is then the difference of two doubles.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot, sqrt
from typing import TypeVar

from msgspec.structs import replace

from judge.problem import Problem
from judge.problem.border import Border, Probe
from judge.topics.circles.part import Part

_Triple = tuple[int, int, int]
_Pair = tuple[float, float]
_Numbers = TypeVar("_Numbers", bound=tuple[object, ...])

_WIDEST = 0.03  # of the extent: a wider gap is not a near miss
_OBLIQUE, _STEEP, _AXIS, _BACK = (3, 4, 5), (-7, 24, 25), (1, 0, 1), (-1, 0, 1)
# Sizes and radii that are in the middle of what `round` makes one number of, or far below it.
_SMALL, _LARGE, _MEDIUM = 2.0**-22, 2.0**20, 2.0**-7
_FAR = 2.0**20  # the offset, in units of the figure
_NARROW, _NARROWEST = 2.0**-6, 2.0**-22  # of the extent: a radius, a length

_LEAST = 2.0**-12  # the same where the promise bounds the radius from below, and half of it still keeps that

_NEAR = 2.0**-4  # an end on the other side of the place than the far one

# The far end is A or B, on the negative side or the positive one: whoever forgets one follows no size at all.
# (direction, scale, along, before, after, offset): circle and line touch, or meet, `along` steps of h from C;
# the line goes `before` steps of (p, q) behind that place and `after` steps beyond it.
_Layout = tuple[_Triple, float, float, float, float, float]
_LINES: Sequence[_Layout] = (
    (_OBLIQUE, 1.0, 0.125, 0.125, 0.15625, 0),
    (_OBLIQUE, _SMALL, 0.125, 0.125, 0.15625, 0),
    (_OBLIQUE, _LARGE, 0.125, 0.125, 0.15625, 0),
    (_AXIS, 1.0, _NARROW, 1, _NEAR, 0),
    (_BACK, 1.0, _NARROWEST, _NEAR, 1, 0),
    (_OBLIQUE, 1.0, 0.125, _NARROW / 8, _NARROW / 8, 0),
    (_AXIS, 1.0, 0.5, 0.75, 1, 0),
    (_STEEP, _MEDIUM, 0.015625, 0.03125, 0.046875, 0),
    (_OBLIQUE, 1.0, 0.125, 0.125, 0.15625, _FAR),
)
_SHORT_AT = 5  # of _LINES: the segment is short there; a line or a ray may also be far from the place
_SHORT_AND_FAR: _Layout = (_AXIS, 1.0, _NARROW, 1, _NARROW - 1, 0)
_ENDS: Sequence[_Layout] = (  # radial lines that end `along` steps from C
    (_OBLIQUE, 1.0, 0.125, 0.375, 0, 0),
    (_OBLIQUE, _SMALL, 0.125, 0.375, 0, 0),
    (_OBLIQUE, _LARGE, 0.125, 0.375, 0, 0),
    (_AXIS, 1.0, _NARROW, 1, 0, 0),
    (_BACK, 1.0, _NARROWEST, 1, 0, 0),
    (_OBLIQUE, 1.0, 0.125, _NARROW / 8, 0, 0),
    (_AXIS, 1.0, 0.5, 1.25, 0, 0),
    (_STEEP, _MEDIUM, 0.015625, 0.0546875, 0, 0),
    (_OBLIQUE, 1.0, 0.125, 0.375, 0, _FAR),
)
_ORIGINS: Sequence[_Layout] = (  # `before` is how long D is
    (_OBLIQUE, 1.0, 0.125, 0.25, 0, 0),
    (_OBLIQUE, _SMALL, 0.125, 0.25, 0, 0),
    (_OBLIQUE, _LARGE, 0.125, 0.25, 0, 0),
    (_OBLIQUE, 1.0, 0.125, _NARROW / 4, 0, 0),
    (_OBLIQUE, 1.0, 0.125, 1 / _NARROW, 0, 0),
    (_OBLIQUE, _MEDIUM, 0.125, 1 / _NARROW, 0, 0),
    (_AXIS, 1.0, 0.5, 1, 0, 0),
    (_STEEP, _MEDIUM, 0.03125, 0.0625, 0, 0),
    (_OBLIQUE, 1.0, 0.125, 0.25, 0, _FAR),
)
_POINTS: Sequence[_Layout] = (
    (_OBLIQUE, 1.0, 0.125, 0, 0, 0),
    (_OBLIQUE, _SMALL, 0.125, 0, 0, 0),
    (_OBLIQUE, _LARGE, 0.125, 0, 0, 0),
    (_OBLIQUE, _MEDIUM, 0.125, 0, 0, 0),
    (_OBLIQUE, 1 / _MEDIUM, 0.125, 0, 0, 0),
    (_AXIS, 1.0, 0.75, 0, 0, 0),
    (_STEEP, _MEDIUM, 0.03125, 0, 0, 0),
    (_OBLIQUE, 1.0, 0.125, 0, 0, _FAR),
    (_AXIS, _SMALL, 0.75, 0, 0, _FAR),
)
# (scale, radius, how far C is beside A, offset) of lines through C that nearly are a point
_SHORT: Sequence[tuple[float, float, float, float]] = (
    (1.0, 0.75, 0.5, 0),
    (_SMALL, 0.75, 0.5, 0),
    (_LARGE, 0.75, 0.5, 0),
    (1.0, _NARROW, 1, 0),
    (1.0, _NARROWEST, 1, 0),
    (1.0, 1, 0.25, 0),
    (_MEDIUM, 0.5, 1, 0),
    (1 / _MEDIUM, 0.75, 0.5, 0),
    (1.0, 0.75, 0.5, _FAR),
)
_INSIDE = 2.0**-22  # of the extent: how far A is inside the circle that a short segment leaves, along it
_ACROSS: Sequence[tuple[_Triple, float, float]] = (  # (direction of A from C, scale, offset)
    (_OBLIQUE, 1.0, 0),
    (_OBLIQUE, _SMALL, 0),
    (_OBLIQUE, _LARGE, 0),
    (_OBLIQUE, _MEDIUM, 0),
    (_OBLIQUE, 1 / _MEDIUM, 0),
    (_AXIS, 1.0, 0),
    ((24, 7, 25), _MEDIUM, 0),
    (_OBLIQUE, 1.0, _FAR),
    (_AXIS, _SMALL, _FAR),
)


def borders(part: Part, problem: Problem) -> tuple[Border, ...]:
    """Those of a problem with the bands `snap` and `clear`; a problem that is exact throughout has none.

    A line alone, or with a point beside it, needs no bands to be none.
    """
    if part in (Part.FOOT, Part.NORMAL):
        return (Border("no line", 0, 0, tuple(_short_alone(each, part) for each in _SHORT)),)
    if not {"snap", "clear"} <= problem.bands.keys():
        return ()
    snap, clear = float(problem.bands["snap"]), float(problem.bands["clear"])
    if part is Part.POINT:
        return (Border("a point", snap, clear, _lone_points(1)),)
    if part is Part.TANGENTS:
        outside = Border("a point on the circle", snap, clear, _lone_points(-1))
        return (outside, Border("a point on the circle from inside", snap, clear, _lone_points(1)))
    ray = part.of_ray
    found = [Border("a tangency", snap, clear, _touches(part, -1))]
    if part is not Part.CHORD and not part.of_vectors:  # where a touch has an answer of the same form
        found.append(Border("a tangency from inside", snap, clear, _touches(part, 1)))
    if part is Part.SEGMENT:
        found += [
            Border("the end B", snap, clear, tuple(_end(each, last=True) for each in _ENDS)),
            Border("the end A", snap, clear, tuple(_end(each, last=False) for each in _ENDS)),
            Border("a single point", snap, clear, tuple(_point(each) for each in _POINTS)),
            Border("a short AB", 0, 0, tuple(map(_across, _ACROSS)), mistaken="points 0"),
        ]
        return tuple(found)
    if ray:
        found += [
            Border("the origin", snap, clear, tuple(_origin(each, -1) for each in _ORIGINS)),
            Border("a point just ahead", 0, 0, tuple(_origin(each, 1) for each in _ORIGINS), mistaken="none"),
        ]
    found.append(
        Border(
            "no direction" if ray else "no line",
            0,
            0,
            tuple(_short(_allowed(each, part), ray=ray) for each in _SHORT),
        )
    )
    return tuple(found)


def _touches(part: Part, side: int) -> tuple[Probe, ...]:
    layouts = list(_LINES)
    if part is not Part.SEGMENT:
        layouts[_SHORT_AT] = _SHORT_AND_FAR
    return tuple(_touch(_allowed(each, part), side, part) for each in layouts)


def _allowed(each: _Numbers, part: Part) -> _Numbers:
    """A layout whose circle is not smaller than the part's promise has it."""
    if not part.of_vectors:
        return each
    return tuple(_LEAST if number == _NARROWEST else number for number in each)  # type: ignore[return-value]


def _touch(each: _Layout, side: int, part: Part) -> Probe:
    """A line that touches the circle with the radius at its edge; -1 draws the circle in, off the line."""
    (p, q, h), scale, along, before, after, far = each
    foot = -q * along, p * along
    start, end = _step(foot, (p, q), -before), _step(foot, (p, q), after)
    radius = h * along
    widest = radius / 2
    if side > 0 and part is Part.SEGMENT:  # half the chord, about √(2·r·gap), stays within the segment
        widest = min(widest, (h * min(before, after)) ** 2 / (4 * radius))
    probe = _probe((start, end), radius, side, widest, scale, far, ray=part.of_ray)
    if side < 0 or not part.of_ray:
        return probe
    # The first point steps back by half the chord, which is √(2·r·gap).
    rest, length = before / (before + after), hypot(p, q) * abs(before + after)
    return replace(probe, rest=rest, step=sqrt(2 * radius / scale) / length)


def _end(each: _Layout, *, last: bool) -> Probe:
    """A radial segment whose one end is on the circle, and just inside it when the radius grows."""
    (p, q, h), scale, along, before, _, far = each
    end = _step((0, 0), (p, q), along)
    start = _step(end, (p, q), -before)
    return _probe((start, end) if last else (end, start), h * along, 1, _WIDEST, scale, far)


def _origin(each: _Layout, side: int) -> Probe:
    """A ray straight away from the circle that it begins on.

    With the side -1 the circle shrinks away behind it, with 1 it grows, and is met just ahead.
    """
    (p, q, h), scale, along, length, _, far = each
    origin = _step((0, 0), (p, q), along)
    ends = origin, _step(origin, (p, q), length)
    return _probe(ends, h * along, side, _WIDEST, scale, far, ray=True, alike=True)


def _point(each: _Layout, side: int = 1) -> Probe:
    """A segment that is a point on the circle, and inside it when the radius grows; -1 shrinks it."""
    (p, q, h), scale, along, _, _, far = each
    place = _step((0, 0), (p, q), along)
    return _probe((place, place), h * along, side, _WIDEST, scale, far, alike=True)


def _lone_points(side: int) -> tuple[Probe, ...]:
    """Points on circles whose radius grows, or with -1 shrinks: (cx, cy, r, P)."""
    probes = (_point(each, side) for each in _POINTS)
    return tuple(replace(probe, case=probe.case[:4]) for probe in probes)


def _probe(
    ends: tuple[_Pair, _Pair],
    radius: float,
    side: int,
    widest: float,
    scale: float,
    far: float,
    *,
    ray: bool = False,
    alike: bool = False,
) -> Probe:
    """A circle about C = (far, −far) whose radius moves, and a line by its two ends as seen from C.

    `alike` says that radius and extent are the same length in all the figures, but for the direction.
    """
    (ax, ay), (bx, by) = ends
    extent = max(radius, abs(ax), abs(ay), *(() if ray else (abs(bx), abs(by))))
    length = hypot(bx - ax, by - ay)
    x, y = far * scale, 0.0 - far * scale  # a zero has no sign
    start = x + ax * scale, y + ay * scale
    second = ((bx - ax) * scale, (by - ay) * scale) if ray else (x + bx * scale, y + by * scale)
    sizes = {
        "extent": extent * scale,
        **({} if alike else {"radius": radius * scale}),
        **({"length of D" if ray else "length of AB": length * scale} if length else {}),
        "coordinate": max(map(abs, (x, y, *start, *(() if ray else second)))),
    }
    case = (x, y, radius * scale, start, second)
    return Probe(case, (2,), radius * scale, side, sizes, min(_WIDEST, widest / extent))


def _short(each: tuple[float, float, float, float], *, ray: bool) -> Probe:
    """A line through C from a place beside it, which is no line where B reaches A, or D is null."""
    scale, *lengths = each
    radius, beside, far = (length * scale for length in lengths)
    extent = max(radius, beside)
    sizes = {"extent": extent, "radius": radius, "coordinate": max(extent, far)}
    case = (beside, far, radius, (0.0, far), (0.0, 0.0 if ray else far))
    return Probe(case, (4, 0), 0.0, 1, sizes, _WIDEST)


def _across(each: tuple[_Triple, float, float]) -> Probe:
    """A segment along x that leaves the circle, as long as the gap; A is inside by the promise and a bit."""
    (p, q, h), scale, offset = each
    far, inside = offset * scale, _INSIDE * h
    start = far + (p - inside) * scale, q * scale - far
    sizes = {"extent": h * scale, "coordinate": max(map(abs, (far, h * scale, *start)))}
    case = (far, -far, h * scale, start, start)
    return Probe(case, (4, 0), start[0], 1, sizes, _WIDEST, least=2 * _INSIDE)


def _short_alone(each: tuple[float, float, float, float], part: Part) -> Probe:
    """The same without a circle: (A, B, P), P on the line, or (A, B)."""
    scale, _, *lengths = each
    beside, far = (length * scale for length in lengths)
    if part is Part.NORMAL:
        start = (beside, far)
        return Probe((start, start), (1, 0), beside, 1, {"extent": max(start)}, _WIDEST)
    sizes = {"extent": beside, "coordinate": max(beside, far)}
    start = (0.0, far)
    return Probe((start, start, (beside, far)), (1, 0), 0.0, 1, sizes, _WIDEST)


def _step(place: _Pair, direction: tuple[int, int], steps: float) -> _Pair:
    """The place so many `direction`s further."""
    return place[0] + direction[0] * steps, place[1] + direction[1] * steps
