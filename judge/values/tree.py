"""Exact answers: what a problem's `solve` returns.

A tree of None, ints, words (str), tuples for fixed parts, and lists or tuples for elements. Its leaves and
wrappers:

    Real(x, unit)         a number x, and the size that a tolerance's `extent` counts in
    Enclosure(x, width)   the number that an interval must hold, and how wide that may be
    Run(items)            neighbouring elements of a list, in any order
    AnyOf(answers)        any of these
    Judged(why_not)       whatever a function of the problem accepts
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
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


class Judged(Struct, frozen=True):
    """Any answer of the type that the problem itself accepts, such as one of very many good ones.

    `why_not(value, group)` says in a sentence why it does not accept a value, or None; it raises nothing for
    one. The value is plain: ints, floats, words, tuples for fixed parts and lists. `group` is the name of the
    test group that the case is in, empty where it is in none. `sample` is an exact answer that is accepted,
    and `group` here is filled in by who judges.
    """

    why_not: Callable[[Any, str], str | None]
    sample: Exact
    group: str = ""


def within(exact: Exact, group: str) -> Exact:
    """The exact answer to a case of that test group."""
    from msgspec.structs import replace

    return replace(exact, group=group) if isinstance(exact, Judged) else exact


def vector(coordinates: Sequence[Surd | Fraction | int], unit: Surd | Fraction | int = 0) -> tuple[Real, ...]:
    """A point or a vector of these exact coordinates, all with one unit."""
    return tuple(Real(x, unit) for x in coordinates)
