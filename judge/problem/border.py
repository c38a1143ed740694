"""The borders at which answers turn, where a submission compares a gap with a threshold of its own.

A probe is a case of which one number moves away from such a border. A submission says
one thing near that edge and another beyond its own threshold; where it changes its mind can be measured.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import sqrt
from typing import Any

from msgspec import Struct

_ROUNDING = 2.0**-49  # of a size: a gap below it is none

Outline = tuple[str, tuple[float, ...]]


class Probe(Struct, frozen=True):
    """A case with a number that moves: at the gap g it is edge + side·g, as a double.

    `place` leads to that number within the case; `edge` is its value at gap 0. `sizes` are lengths of the
    case by their names, in its own units, that of the bands first. `widest` is the greatest gap to ask about,
    as a share of that first size, which is taken at gap 0. `near` and `far` are the forms (`form_of`) of the
    right answers at gap 0 and at the widest one: they are found by `solve`, and left empty until then.

    Where the answer is a number on both sides, `rest` is that number at gap 0, and at the gap g it is about
    step·√g away: what is nearer to `rest` than half of that has the near form.

    Only gaps from `least` on are asked about, as a share of the first size.
    """

    case: tuple[Any, ...]
    place: tuple[int, ...]
    edge: float
    side: int
    sizes: Mapping[str, float]
    widest: float
    near: str = ""
    far: str = ""
    rest: float = 0.0
    step: float = 0.0
    least: float = 0.0

    @property
    def size(self) -> float:
        """The size that the bands count in."""
        return next(iter(self.sizes.values()))

    def form(self, outline: Outline, gap: float) -> str:
        """The form of an answer at that gap."""
        form, (_, numbers) = form_of(outline), outline
        if not self.step or len(numbers) != 1:
            return form
        least = self.step * sqrt(max(gap, _ROUNDING * self.size)) / 2
        return form if abs(numbers[0] - self.rest) < least else f"{form} that has moved"

    def at(self, gap: float) -> tuple[tuple[Any, ...], float]:
        """The case nearest to that gap, and its true gap: a difference of doubles, rounded once."""
        moved = self.edge + self.side * gap
        return _with(self.case, self.place, moved), abs(moved - self.edge)


class Border(Struct, frozen=True):
    """One border and its probes, which differ in size and in whatever else a threshold may follow.

    A gap up to `within` sizes counts as none, one from `beyond` sizes counts; no case has one in between.
    `about` is what is decided, for a sentence: "a touch".

    Where `mistaken` is the form of an answer, the right one does not turn: only a submission that makes a
    mistake answers so near the edge, and below some gap it may be right again.
    """

    about: str
    within: float
    beyond: float
    probes: tuple[Probe, ...]
    mistaken: str = ""


def form_of(outline: Outline) -> str:
    """What tells the two sides of a border apart: an int itself, else the form without its numbers."""
    form, numbers = outline
    return f"{form} {numbers[0]:g}" if form == "count" and numbers else form


def _with(values: tuple[Any, ...], place: tuple[int, ...], number: float) -> tuple[Any, ...]:
    first, *rest = place
    new = _with(values[first], tuple(rest), number) if rest else number
    return (*values[:first], new, *values[first + 1 :])
