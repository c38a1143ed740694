"""What answers turn on where two discs move, and how far a case is from where they turn.

    graze     |d − (r + s)|, d being their least distance, the discs meeting or passing
    start     ||P0 − Q0| − (r + s)|, the discs overlapping or apart
    end       how far the first touch is from t = 1, in time or too late
    motion    how far one disc goes as seen from the other
    reach     r + s

All are in parts of the extent. What may be the extent is told apart at the edges of a band.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial

from judge.exact.surd import Surd
from judge.problem import Case, Problem
from judge.problem.topic import Decision
from judge.topics.circles.bands import Bands
from judge.topics.circles.decisions import tangencies
from judge.topics.circles.motion.balls import Balls

Found = Iterable[tuple[str, float]]
Rolled = Callable[[Balls], Found]

_FINEST = 1e-15  # of the extent: what figures of doubles still hold
_QUANTITIES = (
    "r + s",
    *("x of P0→P1", "y of P0→P1", "x of P0→Q0", "y of P0→Q0", "x of P0→Q1", "y of P0→Q1"),
)


def ball_decisions(problem: Problem) -> tuple[Decision, ...]:
    """The decisions of a problem about two moving discs, with the bands `snap` and `clear`."""
    bands = Bands.of(problem.bands)
    snap, clear = float(bands.snap), float(bands.clear)
    turns: tuple[tuple[str, tuple[str, str], Rolled], ...] = (
        ("graze", ("hit", "miss"), lambda balls: tangencies(balls.line)),
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
    motion, radius = (float(problem.bands[name]) for name in ("least_motion", "least_radius"))
    found.append(Decision("motion", ("motion",), _of(motions), least=motion))
    return (*found, Decision("reach", ("reach",), _of(reaches), least=radius))


def _of(measure: Rolled) -> Callable[[Case], Found]:
    def measured(case: Case) -> Found:
        balls = Balls.of(*case)
        return measure(balls) if balls.line.extent else ()

    return measured


def starts(balls: Balls) -> Iterator[tuple[str, float]]:
    """How far the discs are from touching at the start."""
    gap = Surd(-balls.line.r, 1, balls.apart, balls.line.extent)
    yield ("apart" if gap.sign() > 0 else "overlap"), abs(float(gap))


def ends(bands: Bands, balls: Balls) -> Iterator[tuple[str, float]]:
    """How far the first touch of discs that start apart is from the end."""
    if bands.beside(balls.apart, balls.line.r, balls.line.extent) <= 0:
        return
    first = balls.first(bands)
    if first is not None:
        late = first - 1
        share = abs(float(late)) * balls.pace.step / balls.line.extent
        yield ("too late" if late.sign() > 0 else "in time"), share


def motions(balls: Balls) -> Iterator[tuple[str, float]]:
    """How far one disc goes as seen from the other."""
    if balls.line.a:
        yield "motion", balls.pace.step / balls.line.extent


def reaches(balls: Balls) -> Iterator[tuple[str, float]]:
    """The sum of the radii."""
    if balls.line.r:
        yield "reach", balls.line.r / balls.line.extent


def extents(measure: Rolled, side: str, balls: Balls) -> Iterator[tuple[str, float]]:
    """What `measure` finds on one side, under each quantity that is the extent."""
    (x, y), rest = balls.p[0], (balls.p[1], *balls.q)
    reach = (balls.line.r, *(abs(each) for to in rest for each in (to[0] - x, to[1] - y)))
    for found, share in measure(balls):
        if found == side:
            for name, length in zip(_QUANTITIES, reach, strict=True):
                if length == balls.line.extent:
                    yield name, share
