"""The exact answers a problem's reference returns, one shape per kind of answer."""

from __future__ import annotations

from msgspec import Struct

from judge.exact import Surd


class Count(Struct, frozen=True):
    """How many common points, or None where there is no line."""

    value: int | None


class Points(Struct, frozen=True):
    """The common points (x, y) in order of t; `unit` is the case's extent e, in the caller's units."""

    points: tuple[tuple[Surd, Surd], ...]
    unit: Surd


class Parameter(Struct, frozen=True):
    """The parameter t, or None for a miss; `unit` is e/|D|, the extent in units of t."""

    t: Surd | None
    unit: Surd


Answer = Count | Points | Parameter
