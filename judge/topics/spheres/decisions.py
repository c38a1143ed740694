"""What answers turn on where a ray meets a sphere, and how far a case is from where they turn.

    tangent   |d − r|, the line being a hit or a miss
    origin    a root's distance to the ray's origin, |t|·|D|∞, the root ahead or behind
    radius    r, how small the sphere is seen from the origin
    length    |D|∞, how long the direction is

All are in parts of the extent. What may be the extent is told apart at the edges of a band.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial

from judge.exact.surd import Surd
from judge.problem import Case, Problem
from judge.problem.topic import Decision
from judge.topics.circles import Bands
from judge.topics.spheres.hit import SphereRay

Found = Iterable[tuple[str, float]]
_Measure = Callable[[SphereRay], Found]

_FINEST = 1e-15  # of the extent: what figures of doubles still hold
_QUANTITIES = ("r", "x of C→O", "y of C→O", "z of C→O")


def decisions(problem: Problem) -> tuple[Decision, ...]:
    """The decisions of a problem about the first point of a sphere on a ray."""
    bands = Bands.of(problem.bands)
    snap, clear = float(bands.snap), float(bands.clear)
    turns: tuple[tuple[str, tuple[str, str], _Measure], ...] = (
        ("tangent", ("hit", "miss"), _tangencies),
        ("origin", ("ahead", "behind"), partial(_origins, bands)),
    )
    found = []
    for name, sides, measure in turns:
        found.append(Decision(name, sides, _of(measure), least=_FINEST, within=snap, beyond=clear))
        for side in sides:
            by_extent = _of(partial(_extents, measure, side))
            quantities = _QUANTITIES if name == "tangent" else _QUANTITIES[:1]
            found.append(
                Decision(f"{name}, {side}, by the extent", quantities, by_extent, within=snap, beyond=clear)
            )
    least = float(problem.bands["least_radius"])
    return (
        *found,
        Decision("radius", ("radius",), _of(_radii), least=max(least, 1e-3)),
        Decision("length", ("length",), _of(_lengths), least=1e-3),
    )


def _of(measure: _Measure) -> Callable[[Case], Found]:
    def measured(case: Case) -> Found:
        hit = SphereRay.of(*case)
        return measure(hit) if hit.a and hit.r else ()

    return measured


def _tangencies(hit: SphereRay) -> Iterator[tuple[str, float]]:
    gap = Surd(-hit.r * hit.a, 1, hit.square * hit.a, hit.a * hit.extent)
    yield ("miss" if gap.sign() > 0 else "hit"), abs(float(gap))


def _origins(bands: Bands, hit: SphereRay) -> Iterator[tuple[str, float]]:
    for which in hit.meets(bands):
        t = hit.root(which)
        yield ("ahead" if t.sign() > 0 else "behind"), abs(float(t * hit.step / hit.extent))


def _radii(hit: SphereRay) -> Iterator[tuple[str, float]]:
    yield "radius", hit.r / hit.extent


def _lengths(hit: SphereRay) -> Iterator[tuple[str, float]]:
    yield "length", hit.step / hit.extent


def _extents(measure: _Measure, side: str, hit: SphereRay) -> Iterator[tuple[str, float]]:
    for found, share in measure(hit):
        if found == side:
            for name, length in zip(_QUANTITIES, (hit.r, *map(abs, hit.f)), strict=True):
                if length == hit.extent:
                    yield name, share
