"""A case, its exact answer and the submission's, as exact points in one common unit."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from judge.drawing.frame import ExactNumber
from judge.drawing.shapes import Role
from judge.exact import Surd
from judge.problem.topic import Shown
from judge.topics.circles.bands import Bands
from judge.topics.circles.line import CircleLine
from judge.topics.circles.pair import CirclePair
from judge.topics.circles.part import Part
from judge.topics.circles.picture.answers import foot_of, given_spots, wanted_spots
from judge.topics.circles.picture.arrows import Arrow, arrows_of
from judge.topics.circles.picture.given import read_given
from judge.topics.circles.picture.spots import Spot
from judge.topics.circles.signature import line_of


@dataclass(frozen=True, slots=True)
class Way:
    """A straight piece of the plane from one exact place to another.

    `role` is that of `judge.drawing.shapes.Role`; `beside` is by how much of a panel it is drawn to the left.
    """

    start: tuple[ExactNumber, ExactNumber]
    end: tuple[ExactNumber, ExactNumber]
    role: str
    beside: float


@dataclass(frozen=True, slots=True)
class Scene:
    """Everything a picture is drawn from. Lengths count units of 2**-shift of `line`.

    `wanted` are the exact common points, `given` those of the submission. `snap` is the band's width in
    units of the extent, 0 where the problem has none. `centre` is what C is called where it is no circle's.
    Of many circles `line` is the one that matters, `others` are all others, and `names` are places of the
    case instead of the centre. `ways` are drawn besides.
    `pair` is both circles where there are two; `line` is the first one, and the second's centre. `arrows` are
    vectors of answers that have any, and `met` the point where a ray with such answers meets the circle.
    """

    part: Part
    line: CircleLine
    wanted: tuple[Spot, ...]
    given: tuple[Spot, ...]
    snap: Fraction
    centre: str = "C"
    pair: CirclePair | None = None
    others: tuple[CircleLine, ...] = ()
    names: tuple[Spot, ...] = ()
    ways: tuple[Way, ...] = ()
    arrows: tuple[Arrow, ...] = ()
    met: int | None = None

    def having(self, **changed: Any) -> Scene:
        """The scene with other values of some fields."""
        return replace(self, **changed)

    @property
    def circles(self) -> tuple[CircleLine, ...]:
        """All the circles there are."""
        return self.pair.circles() if self.pair else (self.line, *self.others)

    @property
    def crowded(self) -> bool:
        """Whether there may be too many points to tell in a lens where each of them is."""
        return bool(self.names)

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
    read = read_given(shown.given)
    wanted, given = wanted_spots(part, line, shown.exact), given_spots(part, line, read)
    pair = CirclePair.of(*case) if part.of_pair else None
    met = Bands.of(shown.problem.bands).hit(line) if part.of_vectors else None
    arrows = arrows_of(part, line, shown.exact, read, met) if part.of_vectors else ()
    wanted += tuple(spot for each in arrows for spot in each.spots if each.role is Role.WANTED)
    given += tuple(spot for each in arrows for spot in each.spots if each.role is Role.GOT)
    return Scene(part, line, wanted, given, snap, _centre(part, shown), pair, arrows=arrows, met=met)


def _argument(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value


def _centre(part: Part, shown: Shown) -> str:
    if part is Part.FOOT:
        return list(shown.values)[2]  # P, or whatever the problem calls its point
    return {Part.NORMAL: "(0, 0)", Part.PAIR: "C1", Part.COMMON: "C1"}.get(part, "C")
