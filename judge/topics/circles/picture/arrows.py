"""Vectors in a picture: the normal where a ray meets the circle, or what is reflected there, as arrows."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from judge.drawing.shapes import Role
from judge.topics.circles.line import CircleLine
from judge.topics.circles.part import Part
from judge.topics.circles.picture.given import Drawable
from judge.topics.circles.picture.spots import Spot, digits, root
from judge.values import Exact

_NORMAL = Fraction(1, 3)  # of the extent: how long a normal is drawn
_REFLECTED = Fraction(1, 2)  # and what is as long as D


@dataclass(frozen=True, slots=True)
class Arrow:
    """From a point to another; its role is WANTED or GOT."""

    start: Spot
    tip: Spot
    role: Role

    @property
    def spots(self) -> tuple[Spot, ...]:
        """Both ends, or the tip alone where another arrow has the same start."""
        return (self.start, self.tip) if self.start.text else (self.tip,)


def arrows_of(
    part: Part, line: CircleLine, exact: Exact, given: Drawable, met: int | None
) -> tuple[Arrow, ...]:
    """The exact answer's arrow, and the submission's; `met` is the point that the ray meets first.

    A normal of the submission stands where the ray truly hits, or at O where it hits nothing.
    """
    base = _point(line, met)
    found = []
    if exact is not None and met is not None:
        vector = exact[1] if part is Part.BOUNCE else exact
        x, y = (digits(each.x) for each in vector)
        found.append(_arrow(part, line, base, (x, y), Role.WANTED))
    if part is Part.BOUNCE and len(given.points) > 1:
        one = 1 << line.shift
        (x, y), vector = given.points[:2]
        found.append(_arrow(part, line, (x * one, y * one), vector, Role.GOT))
    elif part is Part.HIT and given.points:
        found.append(_arrow(part, line, base, given.points[0], Role.GOT))
    return tuple(found)


def _point(line: CircleLine, met: int | None) -> tuple[Fraction, Fraction]:
    if met is None:
        return Fraction(line.ax), Fraction(line.ay)
    x, y = line.point(met)
    return digits(x * (1 << line.shift)), digits(y * (1 << line.shift))


def _arrow(
    part: Part,
    line: CircleLine,
    start: tuple[Fraction, Fraction],
    vector: tuple[Fraction, Fraction],
    role: Role,
) -> Arrow:
    """The vector at its place: 1 is a third of the extent long, or |D| half of it."""
    reach = line.extent * _NORMAL
    if part is Part.BOUNCE:
        reach = line.extent * _REFLECTED * (1 << line.shift) / root(line.a or 1)
    tip = Spot(start[0] + vector[0] * reach, start[1] + vector[1] * reach, role.value)
    place = "hit" if role is Role.WANTED else "got hit" if part is Part.BOUNCE else ""
    return Arrow(Spot(*start, place), tip, role)
