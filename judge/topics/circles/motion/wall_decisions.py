"""What answers turn on where a disc moves towards a wall, and how far a case is from where they turn.

    graze     |d − r|, d being the least distance of the wall from the line that P moves along, hit or miss
    start     |d − r|, d being the distance at the start, overlapping or apart
    end       how far the first touch is from t = 1, in time or too late
    motion    how far the disc goes
    wall      how long the wall is
    radius    r

All are in parts of the extent. What may be the extent is told apart at the edges of a band.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from functools import partial

from judge.exact.surd import Surd
from judge.problem import Case, Problem
from judge.problem.topic import Decision
from judge.topics.circles.bands import Bands
from judge.topics.circles.motion.wall import Wall

Found = Iterable[tuple[str, float]]
Walled = Callable[[Wall], Found]

_FINEST = 1e-15  # of the extent: what figures of doubles still hold
_QUANTITIES = ("r", *(f"{axis} of {place}→{end}" for end in "AB" for place in ("P0", "P1") for axis in "xy"))


def wall_decisions(problem: Problem) -> tuple[Decision, ...]:
    """The decisions of a problem about a moving disc and a wall, with the bands `snap` and `clear`."""
    bands = Bands.of(problem.bands)
    snap, clear = float(bands.snap), float(bands.clear)
    turns: tuple[tuple[str, tuple[str, str], Walled], ...] = (
        ("graze", ("hit", "miss"), grazes),
        ("start", ("overlap", "apart"), starts),
        ("end", ("in time", "too late"), partial(ends, bands)),
    )
    found = []
    for name, sides, measure in turns:
        found.append(Decision(name, sides, _of(measure), least=_FINEST, within=snap, beyond=clear))
        for side in sides if name == "graze" else ():
            title = f"{name}, {side}, by the extent"
            by_extent = _of(partial(extents, measure, side))
            found.append(Decision(title, _QUANTITIES, by_extent, within=snap, beyond=clear))
    lengths: tuple[tuple[str, Walled], ...] = (("motion", motions), ("wall", walls), ("radius", radii))
    for name, measure in lengths:
        least = float(problem.bands[f"least_{name}"])
        found.append(Decision(name, (name,), _of(measure), least=least))
    return tuple(found)


def _of(measure: Walled) -> Callable[[Case], Found]:
    def measured(case: Case) -> Found:
        wall = Wall.of(*case)
        return measure(wall) if wall.extent else ()

    return measured


def _gap(wall: Wall, square: Fraction) -> Surd:
    """√square − r, in parts of the extent."""
    top, radius, extent = wall.scaled(square)
    return Surd(-radius, 1, top, extent)


def grazes(wall: Wall) -> Iterator[tuple[str, float]]:
    """How far the line that P moves along is from a graze, if it does not go through the wall itself."""
    if wall.caps[0].a and wall.least:
        gap = _gap(wall, wall.least)
        yield ("miss" if gap.sign() > 0 else "hit"), abs(float(gap))


def starts(wall: Wall) -> Iterator[tuple[str, float]]:
    """How far disc and wall are from touching at the start."""
    gap = _gap(wall, wall.start)
    yield ("apart" if gap.sign() > 0 else "overlap"), abs(float(gap))


def ends(bands: Bands, wall: Wall) -> Iterator[tuple[str, float]]:
    """How far the first touch, of what is apart at the start, is from the end."""
    first = wall.first(bands)
    if first is not None and wall.beside(wall.start, bands) > 0:
        late = first - 1
        share = abs(float(late)) * wall.pace.step / wall.extent
        yield ("too late" if late.sign() > 0 else "in time"), share


def motions(wall: Wall) -> Iterator[tuple[str, float]]:
    """How far the disc goes."""
    if wall.caps[0].a:
        yield "motion", wall.pace.step / wall.extent


def walls(wall: Wall) -> Iterator[tuple[str, float]]:
    """How long the wall is."""
    if any(wall.along):
        yield "wall", max(map(abs, wall.along)) / wall.extent


def radii(wall: Wall) -> Iterator[tuple[str, float]]:
    """How large the disc is."""
    if wall.r:
        yield "radius", wall.r / wall.extent


def extents(measure: Walled, side: str, wall: Wall) -> Iterator[tuple[str, float]]:
    """What `measure` finds on one side, under each quantity that is the extent."""
    reach = (
        wall.r,
        *(abs(end[axis] - place[axis]) for end in wall.wall for place in wall.p for axis in (0, 1)),
    )
    for found, share in measure(wall):
        if found == side:
            for name, length in zip(_QUANTITIES, reach, strict=True):
                if length == wall.extent:
                    yield name, share
