"""What answers turn on where a circle meets a line, and how far a case is from where they turn.

    tangent   |d − r|, the line being a hit or a miss
    end       a root's distance to an end of the segment, the root on it or beyond
    point     ||A − C| − r| where A == B, the point inside or outside
    origin    a root's distance to a ray's origin, the root ahead or behind
    beside    the distance of a point from a line, the point on its left or on its right
    foot      the distance of a foot from the nearest of A and B, the foot before A, after B or between them
    radius    r, how small the circle is seen from a point outside
    apart     |B − A|, how short a line is given; of a ray |D|
    slope     |dx| of a line that is nearly vertical, |dy| of one that is nearly horizontal, in parts of |D|

All but the last are in parts of the extent. What may be the extent is told apart at the edges of a band.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial

from judge.exact.surd import Surd
from judge.problem import Case, Problem
from judge.problem.topic import Decision
from judge.topics.circles.bands import Bands
from judge.topics.circles.line import CircleLine
from judge.topics.circles.part import Part
from judge.topics.circles.signature import line_of, read

Found = Iterable[tuple[str, float]]
Lined = Callable[[CircleLine], Found]

_FINEST = 1e-15  # of the extent: what figures of doubles still hold
_FLATTEST = 1e-12  # of the line: far below what a threshold for a slope would be
_NEAREST = 1e-9  # of the extent: how far a point beside a line may be from it
_EXACT = 1e-30  # what integers of any size are asked for
_QUANTITIES = ("r", "x of the first point", "y of the first point", "x of the second", "y of the second")


def decisions(part: Part, problem: Problem) -> tuple[Decision, ...]:
    """The decisions of a problem about so much of a line; without bands, of one that is exact."""
    if read(part, tuple(_stand_in(each.type.depth) for each in problem.parameters)) is None:
        return ()
    if part in (Part.FOOT, Part.NORMAL):
        return tuple(_beside(part))
    if not problem.bands:
        return (
            Decision("tangent", ("hit", "miss"), _of(part, tangencies), least=_EXACT),
            Decision("apart", ("apart",), _of(part, lengths), least=1e-12),
            Decision("slope", ("vertical", "horizontal"), _of(part, slopes), least=1e-9),
        )
    bands = Bands.of(problem.bands)
    snap, clear = float(bands.snap), float(bands.clear)
    turns: list[tuple[str, tuple[str, ...], Lined]] = []
    if not part.of_point:
        turns.append(("tangent", ("hit", "miss"), tangencies))
    if part is Part.SEGMENT:
        turns.append(("end", ("on", "beyond"), partial(ends, bands)))
    if part is Part.SEGMENT or part.of_point:
        turns.append(("point", ("inside", "outside"), points))
    if part.of_ray:
        turns.append(("origin", ("ahead", "behind"), partial(origins, bands)))
    found = []
    for name, sides, measure in turns:
        found.append(Decision(name, sides, _of(part, measure), least=_FINEST, within=snap, beyond=clear))
        for side in sides:
            quantities = _QUANTITIES[: 3 if part.of_ray or name == "point" else 5]
            if (name, side) == ("point", "inside"):  # the radius is longer than anything else
                quantities = _QUANTITIES[:1]
            by_extent = _of(part, partial(extents, measure, side))
            title = f"{name}, {side}, by the extent"
            found.append(Decision(title, quantities, by_extent, within=snap, beyond=clear))
    if part is Part.TANGENTS or part.of_vectors:
        least = float(problem.bands["least_radius"])
        found.append(Decision("radius", ("radius",), _of(part, radii), least=least))
    if part.of_point:
        return tuple(found)
    least, most = (1e-6, 1e6) if part.of_ray else (_FINEST, 1.0)
    found.append(Decision("apart", ("apart",), _of(part, lengths), least=least, most=most))
    found.append(Decision("slope", ("vertical", "horizontal"), _of(part, slopes), least=_FLATTEST))
    return tuple(found)


def _beside(part: Part) -> Iterator[Decision]:
    """What there is to say of a line without a circle."""
    nearest = _NEAREST if part is Part.FOOT else 1e-6  # no answer is any finer where the origin is beside it
    yield Decision("beside", ("left", "right"), _of(part, besides), least=nearest)
    if part is Part.FOOT:
        yield Decision("foot", ("before", "between", "after"), _of(part, feet), least=1e-6)
    yield Decision("apart", ("apart",), _of(part, lengths), least=_FINEST)
    yield Decision("slope", ("vertical", "horizontal"), _of(part, slopes), least=_FLATTEST)


def _stand_in(depth: int) -> tuple[int, int] | int:
    return (0, 0) if depth else 0


def _of(part: Part, measure: Lined) -> Callable[[Case], Found]:
    def measured(case: Case) -> Found:
        line = line_of(part, case)
        return measure(line) if line is not None and line.extent else ()

    return measured


def tangencies(line: CircleLine) -> Iterator[tuple[str, float]]:
    """|d − r|."""
    if line.a:
        gap = Surd(-line.r * line.a, abs(line.k), line.a, line.a * line.extent)
        yield ("miss" if gap.sign() > 0 else "hit"), abs(float(gap))


def ends(bands: Bands, line: CircleLine) -> Iterator[tuple[str, float]]:
    """How far each common point of the circle and the line is from either end of the segment."""
    for which in bands.meets(line):
        for t in (0, 1):
            away = line.root(which) - t
            inwards = away.sign() if t == 0 else -away.sign()
            yield ("on" if inwards > 0 else "beyond"), _length(line, away)


def points(line: CircleLine) -> Iterator[tuple[str, float]]:
    """||A − C| − r| where the segment is one point."""
    if not line.a:
        square = (line.ax - line.cx) ** 2 + (line.ay - line.cy) ** 2
        gap = Surd(-line.r, 1, square, line.extent)
        yield ("outside" if gap.sign() > 0 else "inside"), abs(float(gap))


def radii(line: CircleLine) -> Iterator[tuple[str, float]]:
    """The radius of a circle that is no point."""
    if line.r:
        yield "radius", line.r / line.extent


def origins(bands: Bands, line: CircleLine) -> Iterator[tuple[str, float]]:
    """How far each common point of the circle and the line is from the ray's origin."""
    for which in bands.meets(line):
        t = line.root(which)
        yield ("ahead" if t.sign() > 0 else "behind"), _length(line, t)


def besides(line: CircleLine) -> Iterator[tuple[str, float]]:
    """The distance of C from the line."""
    if line.k:
        share = line.distance() * (1 << line.shift) / line.extent
        yield ("left" if line.k < 0 else "right"), float(share)


def feet(line: CircleLine) -> Iterator[tuple[str, float]]:
    """How far the foot of the perpendicular from C is from the nearest of A and B, along the line."""
    if line.a:
        t = line.root(0)
        side = "before" if t < 0 else "after" if t > 1 else "between"
        yield side, min(_length(line, t), _length(line, t - 1))


def lengths(line: CircleLine) -> Iterator[tuple[str, float]]:
    """|D|."""
    if line.a:
        yield "apart", float(Surd(0, 1, line.a, line.extent))


def slopes(line: CircleLine) -> Iterator[tuple[str, float]]:
    """The smaller of |dx| and |dy| in parts of |D|."""
    if line.a:
        upright = abs(line.dx) < abs(line.dy)
        share = float(Surd(0, min(abs(line.dx), abs(line.dy)), line.a, line.a))
        yield ("vertical" if upright else "horizontal"), share


def extents(measure: Lined, side: str, line: CircleLine) -> Iterator[tuple[str, float]]:
    """What `measure` finds on one side, under each quantity that is the extent."""
    x, y = line.ax - line.cx, line.ay - line.cy
    reach = (line.r, abs(x), abs(y), abs(x + line.dx), abs(y + line.dy))
    for found, share in measure(line):
        if found == side:
            for name, length in zip(_QUANTITIES, reach, strict=True):
                if length == line.extent:
                    yield name, share


def _length(line: CircleLine, t: Surd) -> float:
    """|t|·|D| in parts of the extent."""
    return abs(float(t)) * float(Surd(0, 1, line.a, line.extent))
