"""A circle and a closed polygon in scaled integers: where the boundary crosses the circle, edge by edge.

OUTLINE   the topic of problems with the arguments (cx, cy, r, V), V being the corners in order
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.exact.dyadic import integers
from judge.exact.surd import Surd
from judge.problem import Case, Problem
from judge.problem.topic import Shown, Topic
from judge.topics.circles.bands import Bands, beyond
from judge.topics.circles.line import CircleLine, Number, Pair

if TYPE_CHECKING:
    from judge.drawing import Picture

Spot = tuple[int, int, int | None]  # an edge, which common point of its line, the end that it is at


class Crossing(Struct, frozen=True):
    """A common point of the circle and the boundary: its edge, and how that edge has it.

    `which` is that of `CircleLine.point` of the line number `line`, the edge itself or the one before.
    """

    edge: int
    line: int
    which: int


class CircleOutline(Struct, frozen=True):
    """A circle and the edges of a polygon, edge i from corner i to the next one, the last one to the first.

    All edges have one shift, and one extent e: the largest of r and |x|, |y| of the corners seen from C.
    """

    edges: tuple[CircleLine, ...]

    @classmethod
    def of(cls, cx: Number, cy: Number, r: Number, corners: Sequence[Pair]) -> CircleOutline:
        """The outline of these. Raises ValueError for nan, infinities and r < 0."""
        (x, y, radius, *flat), shift = integers(cx, cy, r, *(each for corner in corners for each in corner))
        points = list(zip(flat[::2], flat[1::2], strict=True))
        extent = max(radius, *(max(abs(px - x), abs(py - y)) for px, py in points))
        following = [*points[1:], *points[:1]]
        return cls(
            tuple(
                CircleLine.scaled(
                    (x, y, radius), start, (end[0] - start[0], end[1] - start[1]), shift, extent
                )
                for start, end in zip(points, following, strict=True)
            )
        )

    def crossings(self, bands: Bands) -> list[Crossing]:
        """The crossings along the boundary from corner 0; one at a corner is its own edge's, once."""
        return self._crossings(self._spots(bands))

    def _spots(self, bands: Bands) -> list[Spot]:
        """Each common point of an edge's line: the edge's number, `which`, and the end that it is at."""
        return [
            (number, which, bands.end(line, which))
            for number, line in enumerate(self.edges)
            for which in bands.meets(line)
        ]

    def _crossings(self, spots: Sequence[Spot]) -> list[Crossing]:
        found: dict[tuple[int, int], Crossing] = {}
        for number, which, end in spots:
            line = self.edges[number]
            if end is None and not beyond(line, which, 0) > 0 > beyond(line, which, 1):
                continue
            edge = (number + 1) % len(self.edges) if end == 1 else number
            place = (edge, 0) if end is not None else (edge, 2 + which)
            if edge == number or place not in found:
                found[place] = Crossing(edge, number, which)
        return [found[place] for place in sorted(found)]

    def point(self, crossing: Crossing) -> tuple[Surd, Surd]:
        """Where that is, in the caller's units."""
        return self.edges[crossing.line].point(crossing.which)


def simpler_outlines(_problem: Problem, case: Case) -> Iterator[Case]:
    """The circle about the origin, and fewer corners; nothing here need be right."""
    cx, cy, r, corners = case
    if (cx, cy) != (0, 0):
        yield 0, 0, r, tuple((_less(x, cx), _less(y, cy)) for x, y in corners)
    if len(corners) > 3:
        half = len(corners) // 2
        for kept in (corners[:half], corners[half:], corners[::2]):
            if len(kept) >= 3:
                yield cx, cy, r, kept
        for place in range(len(corners)):
            yield cx, cy, r, corners[:place] + corners[place + 1 :]


def _less(x: Number, by: Number) -> Number:
    return x - by if isinstance(x, int) and isinstance(by, int) else float(Fraction(x) - Fraction(by))


def special_outline(case: Case) -> int:
    """One for a radius of 0."""
    return int(case[2] == 0)


def _picture(shown: Shown) -> Picture | None:
    from judge.topics.circles.picture.polygon import draw_outline  # late: most problems are not drawn

    return draw_outline(shown)


OUTLINE = Topic(
    simpler=simpler_outlines,
    special=special_outline,
    picture=_picture,
)
