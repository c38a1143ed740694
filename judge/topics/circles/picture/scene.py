"""A case, its exact answer and the submission's, as exact points in one common unit."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from judge.drawing.frame import ExactNumber
from judge.exact import Surd
from judge.problem.topic import Shown
from judge.topics.circles.line import CircleLine
from judge.topics.circles.part import Part
from judge.topics.circles.picture.given import Drawable, read_given
from judge.topics.circles.signature import circle_and_pairs
from judge.values import Exact, Real


@dataclass(frozen=True, slots=True)
class Spot:
    """An exact point in units of the scene, and its label."""

    x: ExactNumber
    y: ExactNumber
    text: str


@dataclass(frozen=True, slots=True)
class Scene:
    """Everything a picture is drawn from. Lengths count units of 2**-shift of `line`.

    `wanted` are the exact common points, `given` those of the submission. `snap` is the band's width in
    units of the extent, 0 where the problem has none.
    """

    part: Part
    line: CircleLine
    wanted: tuple[Spot, ...]
    given: tuple[Spot, ...]
    snap: Fraction

    @property
    def start(self) -> tuple[int, int]:
        """A, or the ray's origin O."""
        return self.line.ax, self.line.ay

    @property
    def end(self) -> tuple[int, int]:
        """B, or O + D."""
        return self.line.ax + self.line.dx, self.line.ay + self.line.dy

    @property
    def foot(self) -> tuple[Fraction, Fraction]:
        """The point of the line that is next to the centre; A where there is no line."""
        line = self.line
        if not line.a:
            return Fraction(line.ax), Fraction(line.ay)
        return line.cx - Fraction(line.k * line.dy, line.a), line.cy + Fraction(line.k * line.dx, line.a)

    @property
    def gap(self) -> Surd:
        """Distance of the centre from the line (from A, where there is none) less the radius."""
        line = self.line
        if line.a:
            return Surd(-line.r * line.a, abs(line.k), line.a, line.a)
        return Surd(-line.r, 1, (line.ax - line.cx) ** 2 + (line.ay - line.cy) ** 2, 1)


def read_scene(part: Part, shown: Shown) -> Scene | None:
    """The scene of a case, or None where its arguments are not (cx, cy, r, A, B) or (cx, cy, r, O, D)."""
    case = circle_and_pairs(tuple(_argument(value) for value in shown.values.values()))
    if case is None:
        return None
    (cx, cy), radius, first, second = case
    build = CircleLine.ray if part is Part.RAY else CircleLine.through
    line = build(cx, cy, radius, first, second)
    snap = shown.problem.bands.get("snap", Fraction(0))
    given = _given(line, part, read_given(shown.given))
    return Scene(part, line, _wanted(line, shown.exact), given, snap)


def _argument(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value


def _wanted(line: CircleLine, exact: Exact) -> tuple[Spot, ...]:
    one = 1 << line.shift
    if isinstance(exact, list | tuple):
        return _numbered([(Surd.of(x.x) * one, Surd.of(y.x) * one) for x, y in exact], "wanted")
    if isinstance(exact, Real):
        t = Surd.of(exact.x)
        at = (t * line.dx + line.ax, t * line.dy + line.ay)
        return (Spot(*at, f"wanted t = {t.decimal(6)}"),)
    if not exact:
        return ()
    roots = (0,) if exact == 1 else (-1, 1)
    points = [line.point(which) for which in roots]
    return tuple(Spot(x * one, y * one, "common point") for x, y in points)


def _given(line: CircleLine, part: Part, given: Drawable) -> tuple[Spot, ...]:
    one = 1 << line.shift
    if given.points:
        return _numbered([(x * one, y * one) for x, y in given.points], "got")
    if part is not Part.RAY or given.number is None:
        return ()
    t = given.number
    return (Spot(t * line.dx + line.ax, t * line.dy + line.ay, f"got t = {Surd.of(t).decimal(6)}"),)


def _numbered(points: list[tuple[Any, Any]], word: str) -> tuple[Spot, ...]:
    if len(points) == 1:
        return (Spot(*points[0], word),)
    return tuple(Spot(*point, f"{word} {place}") for place, point in enumerate(points, 1))
