"""How simple a case is for a person: few digits, integers before floats, nothing negative without need."""

from __future__ import annotations

import math
from collections.abc import Iterator

from judge.problem.model import Case
from judge.values.atoms import Number

Simplicity = tuple[int, int, tuple[float, ...]]

_NUMBERS = (int, float)
_FLOAT = 2  # a float weighs as much as an integer of so many digits more


def numbers_of(case: Case) -> Iterator[Number]:
    """The numbers of a case, in order, however deep in it; words and None are none."""
    for argument in case:
        if isinstance(argument, tuple):
            yield from numbers_of(argument)
        elif type(argument) in _NUMBERS:  # no bool
            yield argument


def items_of(case: Case) -> int:
    """How many items its lists and points have, however deep in it: as many in all cases of one shape."""
    return sum(len(argument) + items_of(argument) for argument in case if isinstance(argument, tuple))


def with_numbers(case: Case, numbers: Iterator[Number]) -> Case:
    """The case with other numbers in their places."""
    return tuple(
        [
            with_numbers(argument, numbers)
            if isinstance(argument, tuple)
            else next(numbers)
            if type(argument) in _NUMBERS
            else argument
            for argument in case
        ]
    )


def digits(number: Number) -> int:
    """How many characters a person reads: all of an int's digits, what `repr` writes of a float; 0 has none.

    A sign and a float's final `.0` do not count.
    """
    if number == 0:
        return 0
    if isinstance(number, int):
        # Very large ones need not be written to be known as large.
        bits = number.bit_length()
        return len(str(abs(number))) if bits < 2000 else bits * 3 // 10
    return len(repr(abs(number)).removesuffix(".0").replace("e-0", "e-").replace("e+", "e"))


def measure(case: Case) -> Simplicity:
    """What to compare two cases by, the smaller being simpler; an item of a list weighs as a digit."""
    total = items_of(case)
    negative = 0
    magnitudes = []
    for number in numbers_of(case):
        total += digits(number) + (_FLOAT if isinstance(number, float) else 0)
        negative += number < 0
        magnitudes.append(_magnitude(number))
    return total, negative, (math.fsum(magnitudes), *magnitudes)


def _magnitude(number: Number) -> float:
    """The distance from 1 as a factor, either way; 0 is the simplest."""
    try:
        size = abs(float(number))
        return size if size >= 1 or size == 0 else 1 / size
    except (OverflowError, ZeroDivisionError):
        return float("inf")
