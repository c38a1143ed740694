"""Where the boundary of a polygon crosses a circle, edge by edge."""

from __future__ import annotations

from collections.abc import Sequence

from judge.exact.surd import integers
from judge.geometry.quadratic import Number, Point, Quadratic, Vector, on_circle, tangent
from judge.geometry.sure import Sure

_LINE = tangent("The line of an edge").sides[:2]  # which may cut or touch beyond the edge
EDGE = tangent("An edge")
EDGE = EDGE._replace(sides=(*_LINE, EDGE.sides[2]))
_CORNER = on_circle("A corner")
LEAST_EDGE = 1_000_000_000  # an edge is at least size/LEAST_EDGE long


class EdgeLine(Quadratic):
    """A circle and the line of an edge, which runs from t = 0 to t = 1."""

    touch = EDGE
    ends = _CORNER, _CORNER


def edges(cx: Number, cy: Number, r: Number, V: Sequence[Point]) -> list[EdgeLine]:
    """Edge i runs from V[i] to the next corner, the last one to V[0].

    e is the largest of r and all |V[i] − C|∞. Raises InvalidCase where an edge is shorter than 1e-9·e;
    ValueError for nan, infinities and r < 0.
    """
    (x, y, radius, *flat), shift = integers(cx, cy, r, *(number for corner in V for number in corner))
    seen = [(px - x, py - y) for px, py in zip(flat[::2], flat[1::2], strict=True)]
    sure = Sure(max(radius, *(abs(number) for corner in seen for number in corner)))
    found = []
    for start, end in zip(seen, [*seen[1:], seen[0]], strict=True):
        edge = EdgeLine(
            start, (end[0] - start[0], end[1] - start[1]), radius, sure, centre=(x, y), shift=shift
        )
        sure.least(edge.a, LEAST_EDGE, "An edge", zero=False)
        found.append(edge)
    return found


def crossings(cx: Number, cy: Number, r: Number, V: Sequence[Point]) -> list[tuple[int, Vector]]:
    """(edge, point) along the boundary from V[0]; a point at a corner once, with the edge that starts there.

    Raises InvalidCase where an edge's line nearly touches, or a corner is nearly on the circle.
    """
    return [
        (number, edge.real_point(which))
        for number, edge in enumerate(edges(cx, cy, r, V))
        for which in edge.meets()
        if edge.beside(which, 0) >= 0 > edge.beside(which, 1)
    ]
