"""Where answers about a circle and a polygon turn: nine figures each, to measure a threshold in.

As in borders.py the figures differ in size, in the edges' lengths, in direction and in their offset from the
origin. The radius is what moves: an edge touches, or a corner is on the circle and its edges lead away.
"""

from __future__ import annotations

from collections.abc import Sequence

from judge.problem import Problem
from judge.problem.border import Border, Probe

_Triple = tuple[int, int, int]

_OBLIQUE, _STEEP, _AXIS, _BACK = (3, 4, 5), (-7, 24, 25), (1, 0, 1), (-1, 0, 1)
_SMALL, _LARGE, _MEDIUM = 2.0**-22, 2.0**20, 2.0**-7
_FAR = 2.0**20  # the offset, in units of the figure
_WIDEST = 0.01  # of the extent: a wider gap is not a near miss

# (direction of the edge, scale, radius in steps, half the edge in steps, offset)
_Layout = tuple[_Triple, float, float, float, float]
_LAYOUTS: Sequence[_Layout] = (
    (_OBLIQUE, 1.0, 0.125, 0.25, 0),
    (_OBLIQUE, _SMALL, 0.125, 0.25, 0),
    (_OBLIQUE, _LARGE, 0.125, 0.25, 0),
    (_AXIS, 1.0, 0.015625, 1.0, 0),
    (_BACK, 1.0, 0.75, 0.5, 0),
    (_OBLIQUE, 1.0, 0.25, 0.0625, 0),
    (_AXIS, _MEDIUM, 0.5, 0.75, 0),
    (_STEEP, _MEDIUM, 0.015625, 0.03125, 0),
    (_OBLIQUE, 1.0, 0.125, 0.25, _FAR),
)


def outline_borders(problem: Problem) -> tuple[Border, ...]:
    """Those of a problem with the bands `snap` and `clear`."""
    snap, clear = float(problem.bands["snap"]), float(problem.bands["clear"])
    return (
        Border("a touch", snap, clear, tuple(_edge(each, -1) for each in _LAYOUTS)),
        Border("a touch from inside", snap, clear, tuple(_edge(each, 1) for each in _LAYOUTS)),
        Border("a corner on the circle", snap, clear, tuple(_corner(each) for each in _LAYOUTS)),
    )


def _edge(each: _Layout, side: int) -> Probe:
    """A triangle whose first edge touches; the circle shrinks (-1), or grows."""
    (p, q, _), _, along, half, _ = each
    foot = -q * along, p * along
    ends = [(foot[0] + s * p * half, foot[1] + s * q * half) for s in (-1, 1)]
    top = foot[0] - 2 * q * (along + half), foot[1] + 2 * p * (along + half)
    return _probe(each, (*ends, top), side)


def _corner(each: _Layout) -> Probe:
    """A triangle with its first corner on the circle and the others beyond; the circle shrinks."""
    (p, q, _), _, along, half, _ = each
    first = -q * along, p * along
    others = [
        (first[0] - q * half + s * p * half / 2, first[1] + p * half + s * q * half / 2) for s in (-1, 1)
    ]
    return _probe(each, (first, *others), -1)


def _probe(each: _Layout, places: Sequence[tuple[float, float]], side: int) -> Probe:
    (_, _, h), scale, along, half, far = each
    x, y = far * scale, 0.0 - far * scale  # a zero has no sign
    radius = h * along * scale
    reach = max(radius, *(max(abs(a), abs(b)) * scale for a, b in places))
    corners = tuple((x + a * scale, y + b * scale) for a, b in places)
    sizes = {
        "extent": reach,
        "radius": radius,
        "length of the edge": 2 * h * half * scale,
        "coordinate": max(max(map(abs, corner)) for corner in corners),
    }
    # Half the chord, about √(2·r·gap), stays well within the edge.
    widest = min(_WIDEST, radius / reach / 4, (h * half * scale) ** 2 / (8 * radius * reach))
    return Probe((x, y, radius, corners), (2,), radius, side, sizes, widest)
