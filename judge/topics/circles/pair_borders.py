"""Where answers about two circles turn: nine figures each, to measure a threshold in.

As in borders.py the figures differ in size, in the radii, in direction and in their offset from the origin.
All their lengths are small multiples of a power of two along a direction of Pythagorean numbers. The second
radius is what moves.
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

# (direction, scale, |v| in steps, r1 in steps, offset); r2 is what is left of |v|, or of r1
_Layout = tuple[_Triple, float, float, float, float]
_OUTER: Sequence[_Layout] = (
    (_OBLIQUE, 1.0, 0.25, 0.125, 0),
    (_OBLIQUE, _SMALL, 0.25, 0.125, 0),
    (_OBLIQUE, _LARGE, 0.25, 0.125, 0),
    (_OBLIQUE, 1.0, 0.25, 0.015625, 0),
    (_OBLIQUE, 1.0, 0.25, 0.234375, 0),
    (_AXIS, 1.0, 1.0, 0.25, 0),
    (_BACK, _MEDIUM, 1.0, 0.75, 0),
    (_STEEP, _MEDIUM, 0.0625, 0.03125, 0),
    (_OBLIQUE, 1.0, 0.25, 0.125, _FAR),
)
_INNER: Sequence[_Layout] = (
    (_OBLIQUE, 1.0, 0.125, 0.25, 0),
    (_OBLIQUE, _SMALL, 0.125, 0.25, 0),
    (_OBLIQUE, _LARGE, 0.125, 0.25, 0),
    (_OBLIQUE, 1.0, 0.015625, 0.25, 0),
    (_OBLIQUE, 1.0, 0.1875, 0.25, 0),
    (_AXIS, 1.0, 0.25, 1.0, 0),
    (_BACK, _MEDIUM, 0.75, 1.0, 0),
    (_STEEP, _MEDIUM, 0.03125, 0.0625, 0),
    (_OBLIQUE, 1.0, 0.125, 0.25, _FAR),
)


def pair_borders(problem: Problem) -> tuple[Border, ...]:
    """Those of a problem with the bands `snap` and `clear`."""
    snap, clear = float(problem.bands["snap"]), float(problem.bands["clear"])
    return (
        Border("a touch from outside", snap, clear, tuple(_probe(each, -1) for each in _OUTER)),
        Border("a touch from inside", snap, clear, tuple(_probe(each, -1) for each in _INNER)),
        Border("a crossing next to a touch", snap, clear, tuple(_probe(each, 1) for each in _OUTER)),
    )


def _probe(each: _Layout, side: int) -> Probe:
    """Two circles that touch; the second radius grows, or with -1 shrinks."""
    (p, q, h), scale, away, first, far = each
    dx, dy = p * away * scale, q * away * scale
    one = first * h * scale
    two = abs(away - first) * h * scale
    x, y = far * scale, 0.0 - far * scale  # a zero has no sign
    sizes = {
        "extent": max(one, two, abs(dx), abs(dy)),
        "first radius": one,
        "second radius": two,
        "coordinate": max(map(abs, (x, y, x + dx, y + dy))),
    }
    return Probe((x, y, one, x + dx, y + dy, two), (5,), two, side, sizes, _WIDEST)
