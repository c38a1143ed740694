"""The borders at which answers turn, where a submission compares a gap with a threshold of its own.

A probe is a case of which one number moves away from from such a border. A submission says
one thing near that edge and another beyond its own threshold; where it changes its mind can be measured.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from msgspec import Struct


class Probe(Struct, frozen=True):
    """A case with a number that moves: at the gap g it is edge + side·g, as a double.

    `place` leads to that number within the case; `edge` is its value at gap 0. `sizes` are lengths of the
    case by their names, in its own units, that of the bands first. `widest` is the greatest gap to ask about,
    as a share of that first size, which is taken at gap 0. `near` and `far` are the forms (`form_of`) of the
    right answers at gap 0 and at the widest one: they are found by `solve`, and left empty until then.
    """

    case: tuple[Any, ...]
    place: tuple[int, ...]
    edge: float
    side: int
    sizes: Mapping[str, float]
    widest: float
    near: str = ""
    far: str = ""

    @property
    def size(self) -> float:
        """The size that the bands count in."""
        return next(iter(self.sizes.values()))

    def at(self, gap: float) -> tuple[tuple[Any, ...], float]:
        """The case nearest to that gap, and its true gap: a difference of doubles, rounded once."""
        moved = self.edge + self.side * gap
        return _with(self.case, self.place, moved), abs(moved - self.edge)


class Border(Struct, frozen=True):
    """One border and its probes, which differ in size and in whatever else a threshold may follow.

    A gap up to `within` sizes counts as none, one from `beyond` sizes counts; no case has one in between.
    `about` is what is decided, for a sentence: "a touch".
    """

    about: str
    within: float
    beyond: float
    probes: tuple[Probe, ...]


def form_of(outline: tuple[str, tuple[float, ...]]) -> str:
    """What tells the two sides of a border apart: an int itself, else the form without its numbers."""
    form, numbers = outline
    return f"{form} {numbers[0]:g}" if form == "count" and numbers else form


def _with(values: tuple[Any, ...], place: tuple[int, ...], number: float) -> tuple[Any, ...]:
    first, *rest = place
    new = _with(values[first], tuple(rest), number) if rest else number
    return (*values[:first], new, *values[first + 1 :])
