"""What the two answers say, as points: the exact one, and the submission's."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from judge.exact import Surd
from judge.topics.circles.line import CircleLine
from judge.topics.circles.part import Part
from judge.topics.circles.picture.given import Drawable
from judge.topics.circles.picture.spots import Spot, root
from judge.values import Exact, Real

_ARROW = Fraction(1, 3)  # of the extent: how long a normal is drawn


def wanted_spots(part: Part, line: CircleLine, exact: Exact) -> tuple[Spot, ...]:
    """The exact answer's points: common points, a foot, or the tip of a normal."""
    one = 1 << line.shift
    if exact is None or part is Part.POINT or part.of_vectors:
        return ()
    if part is Part.FOOT:
        x, y = foot_of(line)
        return (Spot(x, y, "wanted"),)
    if part is Part.NORMAL:
        (x, y), (a, b) = foot_of(line), line.left_normal()
        reach = line.extent * _ARROW
        return (Spot(a * reach + x, b * reach + y, "wanted"),)
    if part is Part.CHORD:
        return _common(line, 2 if exact.x else 1)
    if isinstance(exact, list | tuple):
        return _numbered([(Surd.of(x.x) * one, Surd.of(y.x) * one) for x, y in exact], "wanted")
    if isinstance(exact, Real):
        t = Surd.of(exact.x)
        at = (t * line.dx + line.ax, t * line.dy + line.ay)
        return (Spot(*at, f"wanted t = {t.decimal(6)}"),)
    return _common(line, exact)


def given_spots(part: Part, line: CircleLine, given: Drawable) -> tuple[Spot, ...]:
    """The submission's points, or what stands for its number: a place along the line, a distance, a chord."""
    one = 1 << line.shift
    if part is Part.NORMAL:
        return _tip(line, given)
    if part.of_vectors:
        return ()
    if given.points:
        return _numbered([(x * one, y * one) for x, y in given.points], "got")
    if given.number is None or part is Part.POINT:
        return ()
    if part is Part.RAY:
        t = given.number
        return (Spot(t * line.dx + line.ax, t * line.dy + line.ay, f"got t = {Surd.of(t).decimal(6)}"),)
    if not line.a:
        return ()
    fx, fy = foot_of(line)
    length = given.number * one
    if part is Part.CHORD:
        steps = length / (2 * root(line.a))
        return _numbered(
            [(fx + step * line.dx, fy + step * line.dy) for step in sorted({-steps, steps})], "got"
        )
    if part is Part.FOOT and line.k:
        share = length / root(Fraction(line.k * line.k, line.a))
        return (Spot(line.cx + share * (fx - line.cx), line.cy + share * (fy - line.cy), "got"),)
    return ()


def foot_of(line: CircleLine) -> tuple[Fraction, Fraction]:
    """The point of the line that is next to the centre; A where there is no line."""
    if not line.a:
        return Fraction(line.ax), Fraction(line.ay)
    return line.cx - Fraction(line.k * line.dy, line.a), line.cy + Fraction(line.k * line.dx, line.a)


def _tip(line: CircleLine, given: Drawable) -> tuple[Spot, ...]:
    """The tip of the normal (a, b), drawn from the foot of the submission's own line a·x + b·y + c = 0."""
    if given.triple is None:
        return ()
    a, b, c = given.triple
    square = a * a + b * b
    if not square:
        return ()
    reach = line.extent * _ARROW - c * (1 << line.shift) / square
    return (Spot(a * reach, b * reach, "got"),)


def _common(line: CircleLine, count: int) -> tuple[Spot, ...]:
    if not count:
        return ()
    one = 1 << line.shift
    points = [line.point(which) for which in ((0,) if count == 1 else (-1, 1))]
    return tuple(Spot(x * one, y * one, "common point") for x, y in points)


def _numbered(points: list[tuple[Any, Any]], word: str) -> tuple[Spot, ...]:
    if len(points) == 1:
        return (Spot(*points[0], word),)
    return tuple(Spot(*point, f"{word} {place}") for place, point in enumerate(points, 1))
