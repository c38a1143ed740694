"""What answers turn on where a ray meets many circles, and how far a case is from where they turn.

    tangent   |d − r| of each circle, the line being a hit or a miss
    origin    how far a hit is from the ray's origin, ahead of it or behind
    between   how far two hits that follow one another are apart

All are in parts of the extent; the last two are |Δt|·|D|∞.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from itertools import pairwise

from judge.problem import Case, Problem
from judge.problem.topic import Decision
from judge.topics.circles.bands import Bands
from judge.topics.circles.crowd import Crowd
from judge.topics.circles.decisions import tangencies

Found = Iterable[tuple[str, float]]

_FINEST = 1e-15  # of the extent: what figures of doubles still hold


def crowd_decisions(problem: Problem) -> tuple[Decision, ...]:
    """The decisions of a problem about circles and a ray with the bands `snap` and `clear`."""
    bands = Bands.of(problem.bands)
    snap, clear = float(bands.snap), float(bands.clear)
    turns: tuple[tuple[str, tuple[str, ...], Callable[[Crowd], Found]], ...] = (
        ("tangent", ("hit", "miss"), _touches),
        ("origin", ("ahead", "behind"), partial(_origins, bands)),
        ("between", ("apart",), partial(_gaps, bands)),
    )
    return tuple(
        Decision(name, sides, _of(measure), least=_FINEST, within=snap, beyond=clear)
        for name, sides, measure in turns
    )


def _of(measure: Callable[[Crowd], Found]) -> Callable[[Case], Found]:
    def measured(case: Case) -> Found:
        crowd = Crowd.of(*case[:3])
        return measure(crowd) if crowd.extent else ()

    return measured


def _touches(crowd: Crowd) -> Iterator[tuple[str, float]]:
    for line in crowd.lines:
        yield from tangencies(line)


def _origins(bands: Bands, crowd: Crowd) -> Iterator[tuple[str, float]]:
    for hit in crowd.every_hit(bands):
        t = crowd.lines[hit.index].root(hit.side)
        yield ("ahead" if t.sign() > 0 else "behind"), abs(float(t / crowd.unit()))


def _gaps(bands: Bands, crowd: Crowd) -> Iterator[tuple[str, float]]:
    hits = crowd.ahead(crowd.every_hit(bands), bands)
    for one, other in pairwise(hits):
        yield "apart", crowd.gap(one, other)
