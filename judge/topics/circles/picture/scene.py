"""A case, its exact answer and the submission's, as exact points in one common unit."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from judge.exact import Surd
from judge.problem.topic import Shown
from judge.topics.circles.line import CircleLine
from judge.topics.circles.pair import CirclePair
from judge.topics.circles.part import Part
from judge.topics.circles.picture.answers import Spot, foot_of, given_spots, wanted_spots
from judge.topics.circles.picture.given import read_given
from judge.topics.circles.signature import line_of


@dataclass(frozen=True, slots=True)
class Scene:
    """Everything a picture is drawn from. Lengths count units of 2**-shift of `line`.

    `wanted` are the exact common points, `given` those of the submission. `snap` is the band's width in
    units of the extent, 0 where the problem has none. `centre` is what C is called where it is no circle's.
    `pair` is both circles where there are two; `line` is the first one, and the second's centre.
    """

    part: Part
    line: CircleLine
    wanted: tuple[Spot, ...]
    given: tuple[Spot, ...]
    snap: Fraction
    centre: str = "C"
    pair: CirclePair | None = None

    @property
    def circles(self) -> tuple[CircleLine, ...]:
        """All the circles there are."""
        return self.pair.circles() if self.pair else (self.line,)

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
        return foot_of(self.line)

    @property
    def gap(self) -> Surd:
        """Distance of the centre from the line (from A, where there is none) less the radius."""
        line = self.line
        if line.a:
            return Surd(-line.r * line.a, abs(line.k), line.a, line.a)
        return Surd(-line.r, 1, (line.ax - line.cx) ** 2 + (line.ay - line.cy) ** 2, 1)


def read_scene(part: Part, shown: Shown) -> Scene | None:
    """The scene of a case, or None where its arguments are none of that kind."""
    case = tuple(_argument(value) for value in shown.values.values())
    line = line_of(part, case)
    if line is None:
        return None
    snap = shown.problem.bands.get("snap", Fraction(0))
    wanted = wanted_spots(part, line, shown.exact)
    given = given_spots(part, line, read_given(shown.given))
    pair = CirclePair.of(*case) if part.of_pair else None
    return Scene(part, line, wanted, given, snap, _centre(part, shown), pair)


def _argument(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value


def _centre(part: Part, shown: Shown) -> str:
    if part is Part.FOOT:
        return list(shown.values)[2]  # P, or whatever the problem calls its point
    return {Part.NORMAL: "(0, 0)", Part.PAIR: "C1", Part.COMMON: "C1"}.get(part, "C")
