"""What answers turn on where two circles meet, and how far a case is from where they turn.

    outer      ||v| − (r1 + r2)|, the circles crossing or apart
    inner      ||v| − |r1 − r2||, the circles crossing or one inside the other
    same       |r1 − r2| about one centre, the first circle the greater one or the second
    centres    |v|, how far apart the centres are, and how near to one another

All are in parts of the extent. What may be the extent is told apart at the edges of a band.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial

from judge.exact.surd import Surd
from judge.problem import Case, Problem
from judge.problem.topic import Decision
from judge.topics.circles.bands import Bands
from judge.topics.circles.pair import CirclePair

Found = Iterable[tuple[str, float]]
Paired = Callable[[CirclePair], Found]

_FINEST = 1e-15  # of the extent: what figures of doubles still hold
_QUANTITIES = ("r1", "r2", "x of C1→C2", "y of C1→C2")


def pair_decisions(problem: Problem) -> tuple[Decision, ...]:
    """The decisions of a problem about two circles with the bands `snap` and `clear`, and centres `apart`."""
    bands = Bands.of(problem.bands)
    snap, clear = float(bands.snap), float(bands.clear)
    turns: list[tuple[str, tuple[str, ...], Paired, int]] = [
        ("outer", ("crossing", "apart"), partial(touches, bands, 0), 4),
        (
            "inner",
            ("crossing", "inside"),
            partial(touches, bands, 1),
            2,
        ),  # v is shorter than a radius
        ("same", ("first", "second"), partial(radii, bands), 0),
    ]
    found = []
    for name, sides, measure, most in turns:
        least = _FINEST if most else None
        found.append(Decision(name, sides, _of(measure), least=least, within=snap, beyond=clear))
        for side in sides if most else ():
            title = f"{name}, {side}, by the extent"
            by_extent = _of(partial(extents, measure, side))
            found.append(Decision(title, _QUANTITIES[:most], by_extent, within=snap, beyond=clear))
    apart = float(problem.bands["apart"])
    return (*found, Decision("centres", ("apart",), _of(centres), within=snap, beyond=apart))


def _of(measure: Paired) -> Callable[[Case], Found]:
    def measured(case: Case) -> Found:
        pair = CirclePair.of(*case)
        return measure(pair) if pair.extent else ()

    return measured


def touches(bands: Bands, which: int, pair: CirclePair) -> Iterator[tuple[str, float]]:
    """How far the circles are from a touch, from outside (0) or one inside the other (1)."""
    if bands.beside(pair.square, 0, pair.extent) == 0:
        return
    gap = Surd(-pair.reaches[which], 1, pair.square, pair.extent)
    beyond = gap.sign() if which == 0 else -gap.sign()
    yield (("apart", "inside")[which] if beyond > 0 else "crossing"), abs(float(gap))


def radii(bands: Bands, pair: CirclePair) -> Iterator[tuple[str, float]]:
    """How much the radii of circles about one centre differ."""
    if bands.beside(pair.square, 0, pair.extent) == 0:
        yield ("first" if pair.r1 > pair.r2 else "second"), abs(pair.r1 - pair.r2) / pair.extent


def centres(pair: CirclePair) -> Iterator[tuple[str, float]]:
    """How far apart the centres are."""
    yield "apart", float(Surd(0, 1, pair.square, pair.extent))


def extents(measure: Paired, side: str, pair: CirclePair) -> Iterator[tuple[str, float]]:
    """What `measure` finds on one side, under each quantity that is the extent."""
    reach = (pair.r1, pair.r2, abs(pair.dx), abs(pair.dy))
    for found, share in measure(pair):
        if found == side:
            for name, length in zip(_QUANTITIES, reach, strict=True):
                if length == pair.extent:
                    yield name, share
