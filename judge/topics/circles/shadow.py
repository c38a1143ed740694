"""Whether a light reaches the first hit of a ray, decided in integers.

The first hit is P = O + (u/a)·D with u = p + q·√d. Multiplied by a, its coordinates are in Z[√d], and so is
all that follows from them by sums and products: every question is the sign of such a number. A segment from P
to the light L meets another circle where just one of its ends is inside, or both are outside and the nearest
point of the line lies between them and inside.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum

from msgspec import Struct

from judge.exact.signs import root_sign
from judge.topics.circles.crowd import Crowd, Hit
from judge.topics.circles.line import CircleLine

Root = tuple[int, int]  # (p, q) of p + q·√d


class Shade(Enum):
    """What the light is to the first hit."""

    NOTHING = "nothing"  # the ray hits nothing
    LIT = "lit"
    BACK = "back"  # it is on the side that the ray does not see
    OWN = "own"  # the circle's own far wall is between
    BLOCKED = "blocked"  # another circle is


class View(Struct, frozen=True):
    """Another circle as seen from the first hit: all lengths times a, as p + q·√d but for the radius.

    `away` is P − C and `square` its square, `cross` the square of (L − P) × (P − C).
    """

    line: CircleLine
    radius: int
    away: tuple[Root, Root]
    square: Root
    cross: Root


class Shadow(Struct, frozen=True):
    """The first hit of a scene, which has one, and the way from there to the light; all times a.

    `way` is L − P, `outward` is P − C; both are pairs of p + q·√d.
    """

    crowd: Crowd
    hit: Hit
    point: tuple[Root, Root]
    way: tuple[Root, Root]
    outward: tuple[Root, Root]
    light: tuple[int, int]

    @classmethod
    def of(cls, crowd: Crowd, hit: Hit) -> Shadow:
        """The scene's own; its light is the only place that the crowd has besides."""
        line = crowd.lines[hit.index]
        (light,) = crowd.places
        a = line.a
        point = tuple(
            (a * start + hit.p * step, hit.q * step)
            for start, step in zip(crowd.origin, crowd.direction, strict=True)
        )
        way = tuple((a * end - p, -q) for end, (p, q) in zip(light, point, strict=True))
        outward = tuple((p - a * mid, q) for mid, (p, q) in zip((line.cx, line.cy), point, strict=True))
        return cls(crowd, hit, point, way, outward, light)  # type: ignore[arg-type]  # pairs

    def views(self) -> list[View]:
        """All circles but the one that is hit."""
        (px, qx), (py, qy) = self.point
        found = []
        for index, line in enumerate(self.crowd.lines):
            if index == self.hit.index:
                continue
            away = (px - line.a * line.cx, qx), (py - line.a * line.cy, qy)
            cross = self._minus(self._times(self.way[0], away[1]), self._times(self.way[1], away[0]))
            square = self._dot(away, away)
            found.append(View(line, line.r * line.a, away, square, self._times(cross, cross)))
        return found

    def shade(self, views: Sequence[View]) -> Shade:
        """Whether the light reaches the point, and if not, why."""
        if self._sign(self._facing()) != -self.hit.side:
            return Shade.BACK
        own = self.crowd.lines[self.hit.index]
        if self.hit.side > 0 and _outside(own, self.light) > 0:
            return Shade.OWN
        return Shade.BLOCKED if any(map(self._blocks, views)) else Shade.LIT

    def _blocks(self, view: View) -> bool:
        """Whether another circle has a point between the hit and the light."""
        power = view.radius * view.radius
        here = self._sign((view.square[0] - power, view.square[1]))
        there = _outside(view.line, self.light)
        if here != there or here < 0:
            return here != there
        along, length = self._dot(view.away, self.way), self._dot(self.way, self.way)
        if self._sign(along) >= 0 or self._sign(self._plus(along, length)) <= 0:
            return False
        chord = self._minus((power * length[0], power * length[1]), view.cross)
        return self._sign(chord) > 0

    def _facing(self) -> Root:
        """(L − P)·(P − C), above 0 where the light is on the outer side of the tangent at P."""
        return self._dot(self.way, self.outward)

    def _sign(self, value: Root) -> int:
        return root_sign(*value, self.hit.d)

    def _times(self, one: Root, other: Root) -> Root:
        (p, q), (u, v) = one, other
        return p * u + q * v * self.hit.d, p * v + q * u

    def _plus(self, one: Root, other: Root) -> Root:
        return one[0] + other[0], one[1] + other[1]

    def _minus(self, one: Root, other: Root) -> Root:
        return one[0] - other[0], one[1] - other[1]

    def _dot(self, one: tuple[Root, Root], other: tuple[Root, Root]) -> Root:
        return self._plus(self._times(one[0], other[0]), self._times(one[1], other[1]))


def _square(line: CircleLine, place: tuple[int, int]) -> int:
    return (place[0] - line.cx) ** 2 + (place[1] - line.cy) ** 2


def _outside(line: CircleLine, place: tuple[int, int]) -> int:
    """1 outside the circle, -1 inside it, 0 on it."""
    power = _square(line, place) - line.r * line.r
    return (power > 0) - (power < 0)
