"""Whether a light reaches the first hit of a ray among circles.

The first hit is P = O + (u/a)·D with u = −b ± √Δ, so that P times a has coordinates p + q·√Δ, and so has all
that follows from it by sums and products: each question is the sign of such a number. The way from P to the
light L meets another circle where just one of P and L is inside, or both are outside and the foot of the
perpendicular from the centre lies between them and inside.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum

from judge.exact.signs import root_sign
from judge.geometry.crowd import Circle, Crowd, Hit
from judge.geometry.quadratic import LEAST_RADIUS, Point, Quadratic, on_circle, tangent
from judge.geometry.sure import DecisionWords, Root, Sure

GRAZE = 1_000_000  # L is at least size/GRAZE off the tangent at P


class Shade(Enum):
    """What the light is to the first hit."""

    NOTHING = "nothing"  # the ray hits nothing
    LIT = "lit"
    BACK = "back"  # L is on the side of the tangent that the ray does not see
    OWN = "own"  # the circle's own far wall is between
    BLOCKED = "blocked"  # another circle is


_ORIGIN, _LIGHT, _HIT = (
    on_circle("O", "a circle"),
    on_circle("L", "a circle"),
    on_circle("P", "another circle"),
)
_RAY, _WAY = tangent("The ray's line", "a circle"), tangent("The line from P to L", "a circle")
LEVEL = DecisionWords(
    "L is almost on the tangent at P",
    "It must be at least 1e-6·e away.",
    ("L is behind the tangent at P", "L is exactly on the tangent at P", "L is before the tangent at P"),
)

AGAIN = DecisionWords(
    "The line from P to L almost meets P's own circle at P alone",
    "It must meet it again at least 1e-7·e away.",
    ("", "", "the line from P to L meets P's own circle again beside P"),
)


def shade(circles: Sequence[Circle], O: Point, D: Point, L: Point) -> Shade:
    """What the light L is to the point P that the ray O + t·D, t >= 0, hits first.

    e is the largest of all r, all |C − O|∞ and |L − O|∞. Raises InvalidCase where any of these decisions is
    close or exactly 0, for r < e/10,000, and where D is (0, 0); ValueError for nan, infinities and r < 0.
    """
    crowd = Crowd(circles, O, D, L)
    (light,) = crowd.points
    sure, outside = crowd.sure, []
    for circle in crowd.circles:
        sure.least(circle.r * circle.r, LEAST_RADIUS, "A radius", zero=False)
        sure.distance(circle.square, circle.r, zero=False, what=_ORIGIN)
        across = circle.a * circle.square - circle.b * circle.b
        sure.distance(across, circle.r, circle.a, zero=False, what=_RAY)
        square = sum((x + f) ** 2 for x, f in zip(light, circle.f, strict=True))
        outside.append(sure.distance(square, circle.r, zero=False, what=_LIGHT))
    # No two hits are at one place: P would be on another circle, which is refused below.
    first = next(iter(crowd.hits()), None)
    return Shade.NOTHING if first is None else _Scene(crowd, first, light).shade(outside)


class _Scene:
    """The first hit and the light; numbers p + q·√Δ are pairs, lengths times a."""

    def __init__(self, crowd: Crowd, hit: Hit, light: tuple[int, int]) -> None:
        self.crowd, self.hit = crowd, hit
        own = self.own = crowd.circles[hit.circle]
        self.root, self.sure = own.delta, Sure(crowd.sure.size * own.a)
        if own.parts(1)[0][1] == own.parts(1)[1][1] == 0:
            self.root = 0  # √Δ is a whole number
        self.outward = own.parts(hit.which)
        self.way = [
            (own.a * (x + f) - p, -q) for x, f, (p, q) in zip(light, own.f, self.outward, strict=True)
        ]

    def shade(self, outside: Sequence[int]) -> Shade:
        """`outside` is 1 or -1 for each circle: whether L is outside of it."""
        own, sure = self.own, self.sure
        facing = sure.sign(
            *self._dot(self.way, self.outward),
            self.root,
            per=(own.r * own.a) ** 2,
            share=GRAZE,
            zero=False,
            what=LEVEL,
        )
        sure.nested(
            self._root(self._times(*2 * [self._dot(self.way, [(2 * p, 2 * q) for p, q in self.outward])])),
            0,
            self._root(self._dot(self.way, self.way)),
            zero=False,
            what=AGAIN,
        )
        views = [
            self._blocks(circle, outside[index])
            for index, circle in enumerate(self.crowd.circles)
            if index != self.hit.circle
        ]
        if facing != -self.hit.which:
            return Shade.BACK
        if self.hit.which > 0 and outside[self.hit.circle] > 0:
            return Shade.OWN
        return Shade.BLOCKED if any(views) else Shade.LIT

    def _blocks(self, circle: Quadratic, there: int) -> bool:
        """Whether another circle has a point between P and L."""
        a = self.own.a
        away = [
            (p + a * (f - g), q) for (p, q), f, g in zip(self.outward, circle.f, self.own.f, strict=True)
        ]  # P as seen from its centre
        way, radius, one = self.way, circle.r * a, Root(1)
        here = self.sure.nested(self._root(self._dot(away, away)), radius, one, zero=False, what=_HIT)
        (p, q), (u, v) = self._times(way[0], away[1]), self._times(way[1], away[0])
        cross = p - u, q - v
        length, along = self._dot(way, way), self._dot(away, way)
        far = self.sure.nested(
            self._root(self._times(cross, cross)), radius, self._root(length), zero=False, what=_WAY
        )
        if here != there or here < 0:
            return here != there
        between = self._sign(along) < 0 < self._sign((along[0] + length[0], along[1] + length[1]))
        return between and far < 0

    def _root(self, value: tuple[int, int]) -> Root:
        return Root(*value, self.root)

    def _sign(self, value: tuple[int, int]) -> int:
        return root_sign(*value, self.root)

    def _times(self, one: tuple[int, int], other: tuple[int, int]) -> tuple[int, int]:
        (p, q), (u, v) = one, other
        return p * u + q * v * self.root, p * v + q * u

    def _dot(self, one: Sequence[tuple[int, int]], other: Sequence[tuple[int, int]]) -> tuple[int, int]:
        (p, q), (u, v) = (self._times(x, y) for x, y in zip(one, other, strict=True))
        return p + u, q + v
