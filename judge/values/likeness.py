"""What kinds of wrong answers there are: what is worth telling apart when two programs err.

Numbers are held against each other by how they miss the wanted ones, whatever the size of the figure.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from operator import sub

from msgspec import Struct

CLOSE = 1e-3  # of the largest number: an error that is smaller is one of digits
SAME = 0.05  # of the larger error: numbers that differ by less are the same
_FEW = 8  # different answers, up to which any other number is the mark of having none

Outline = tuple[str, tuple[float, ...]]


class Usual(Struct, frozen=True):
    """What the right answers of a problem's data are like: the numbers that occur, where these are few."""

    few: frozenset[float] = frozenset()
    negative: bool = False

    @classmethod
    def of(cls, rights: Iterable[Outline]) -> Usual:
        """That of the outlines of right answers."""
        numbers = {number for _, found in rights for number in found}
        few = numbers | {0.0, 1.0, 2.0}
        return cls(frozenset(few) if len(few) <= _FEW else frozenset(), min(numbers, default=0.0) < 0.0)


def largest(numbers: Sequence[float], others: Sequence[float]) -> float:
    """The largest difference of two numbers in the same place."""
    return max(map(abs, map(sub, numbers, others)), default=0.0)


def only_digits(numbers: Sequence[float], wanted: Sequence[float]) -> bool:
    """Whether numbers differ from as many wanted ones by no more than lost digits."""
    return largest(numbers, wanted) <= CLOSE * max(map(abs, (*numbers, *wanted)), default=0.0)


def reordered(numbers: Sequence[float], wanted: Sequence[float], count: int) -> bool:
    """Whether the numbers of so many items are those wanted in another order."""
    size = len(wanted) // count if count else 0
    if count < 2 or not size or size * count != len(wanted) or len(numbers) != len(wanted):
        return False
    if count == 2:
        turned = (*wanted[size:], *wanted[:size])
        return largest(numbers, turned) <= SAME * largest(wanted, turned)
    given, right = (
        sorted(tuple(each[at : at + size]) for at in range(0, len(each), size)) for each in (numbers, wanted)
    )
    return only_digits([x for item in given for x in item], [x for item in right for x in item])
