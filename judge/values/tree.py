"""Exact answers: what a problem's `solve` returns.

A tree of None, ints, words (str), tuples for fixed parts, and lists or tuples for elements. Its leaves and
wrappers:

    Real(x, unit)         a number x, and the size that a tolerance's `extent` counts in
    Enclosure(x, width)   the number that an interval must hold, and how wide that may be
    Run(items)            neighbouring elements of a list, in any order
    AnyOf(answers)        any of these
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from msgspec import Struct

if TYPE_CHECKING:
    from judge.exact import Surd

Exact = Any  # such a tree


class Real(Struct, frozen=True):
    """An exact real number; `unit` >= 0 is in the units of x.

    Only a problem whose tolerance has no `extent` may have an irrational unit.
    """

    x: Surd | Fraction | int
    unit: Surd | Fraction | int = 0


class Enclosure(Struct, frozen=True):
    """An interval (lo, hi) is wanted that holds x and has hi − lo <= width."""

    x: Surd | Fraction | int
    width: Fraction | int


class Run(Struct, frozen=True):
    """Elements of the list around it that may come in any order, such as those of a tie.

    The elements of a run differ in their ints or words: each given one is held against the first wanted one
    left that accepts it.
    """

    items: Sequence[Exact]


class AnyOf(Struct, frozen=True):
    """Any of these answers is right; the first of them is the one that is shown."""

    answers: Sequence[Exact]


def vector(coordinates: Sequence[Surd | Fraction | int], unit: Surd | Fraction | int = 0) -> tuple[Real, ...]:
    """A point or a vector of these exact coordinates, all with one unit."""
    return tuple(Real(x, unit) for x in coordinates)
