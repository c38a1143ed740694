"""Where answers about two moving discs turn: nine figures each, to measure a threshold in.

As in borders.py the figures differ in size, in the radii, in the way, in direction and in their offset from
the origin, one of them at a time. All their lengths are small multiples of a power of two along a direction
of Pythagorean numbers. Q is at rest, the reach is shared by both radii, and r is what moves.
"""

from __future__ import annotations

from collections.abc import Sequence

from judge.problem import Problem
from judge.problem.border import Border, Probe

_Triple = tuple[int, int, int]
FloatPair = tuple[float, float]

_OBLIQUE, _STEEP, _AXIS, _BACK = (3, 4, 5), (-7, 24, 25), (1, 0, 1), (-1, 0, 1)
_SMALL, _LARGE, _MEDIUM = 2.0**-22, 2.0**20, 2.0**-7
_FAR = 2.0**20  # the offset, in units of the figure
WIDEST = 0.01  # of the extent: a wider gap is not a near miss
_NARROW = 2.0**-6

# The layouts of motions, towards walls as well: (direction, scale, the reach in steps, the way before the
# touch and after it in steps, offset)
Layout = tuple[_Triple, float, float, float, float, float]
GRAZES: Sequence[Layout] = (
    (_OBLIQUE, 1.0, 0.125, 0.25, 0.125, 0),
    (_OBLIQUE, _SMALL, 0.125, 0.25, 0.125, 0),
    (_OBLIQUE, _LARGE, 0.125, 0.25, 0.125, 0),
    (_OBLIQUE, 1.0, 0.015625, 0.25, 0.125, 0),
    (_OBLIQUE, 1.0, 0.125, 0.25, 8, 0),
    (_AXIS, 1.0, 0.5, 0.75, 1, 0),
    (_BACK, _MEDIUM, _NARROW, 1, 0.125, 0),
    (_STEEP, _MEDIUM, 0.015625, 0.03125, 0.046875, 0),
    (_OBLIQUE, 1.0, 0.125, 0.25, 0.125, _FAR),
)
# Where discs leave each other or come together, `before` is how long the way is.
STRAIGHT: Sequence[Layout] = (
    (_OBLIQUE, 1.0, 0.125, 0.25, 0, 0),
    (_OBLIQUE, _SMALL, 0.125, 0.25, 0, 0),
    (_OBLIQUE, _LARGE, 0.125, 0.25, 0, 0),
    (_OBLIQUE, 1.0, 0.125, 8, 0, 0),
    (_OBLIQUE, 1.0, 0.125, _NARROW, 0, 0),
    (_AXIS, 1.0, 0.5, 1, 0, 0),
    (_BACK, _MEDIUM, _NARROW, 1, 0, 0),
    (_STEEP, _MEDIUM, 0.03125, 0.0625, 0, 0),
    (_OBLIQUE, 1.0, 0.125, 0.25, 0, _FAR),
)


def ball_borders(problem: Problem) -> tuple[Border, ...]:
    """Those of a problem with the bands `snap` and `clear`; each time the radius shrinks."""
    snap, clear = float(problem.bands["snap"]), float(problem.bands["clear"])
    return (
        Border("a graze", snap, clear, tuple(map(_graze, GRAZES))),
        Border("a touch at the start", snap, clear, tuple(map(_start, STRAIGHT))),
        Border("a touch at the end", snap, clear, tuple(map(_end, STRAIGHT))),
    )


def _graze(each: Layout) -> Probe:
    (p, q, _), _, reach, before, after, _ = each
    foot = -q * reach, p * reach
    return _probe(each, step(foot, (p, q), -before), step(foot, (p, q), after))


def _start(each: Layout) -> Probe:
    (p, q, _), _, reach, length, _, _ = each
    start = step((0, 0), (p, q), reach)
    return _probe(each, start, step(start, (p, q), length))


def _end(each: Layout) -> Probe:
    (p, q, _), _, reach, length, _, _ = each
    end = step((0, 0), (p, q), -reach)
    return _probe(each, step(end, (p, q), -length), end)


def _probe(each: Layout, start: FloatPair, end: FloatPair) -> Probe:
    """Two discs of which Q is at rest in (far, −far); r shrinks from half the reach."""
    (_, _, h), scale, steps, _, _, far = each
    reach = h * steps * scale
    x, y = far * scale, 0.0 - far * scale  # a zero has no sign
    first, last = ((x + at[0] * scale, y + at[1] * scale) for at in (start, end))
    way = last[0] - first[0], last[1] - first[1]
    sizes = {
        "extent": max(reach, *map(abs, (*way, x - first[0], y - first[1]))),
        "sum of the radii": reach,
        "way": max(map(abs, way)),
        "coordinate": max(map(abs, (x, y, *first, *last))),
    }
    case = (first, last, reach / 2, (x, y), (x, y), reach / 2)
    return Probe(case, (2,), reach / 2, -1, sizes, min(WIDEST, reach / sizes["extent"] / 4))


def step(place: FloatPair, direction: tuple[int, int], steps: float) -> FloatPair:
    """The place so many `direction`s further."""
    return place[0] + direction[0] * steps, place[1] + direction[1] * steps
