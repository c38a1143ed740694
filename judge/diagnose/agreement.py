"""How alike two wrong answers to one case are, between 0 and 1.

Numbers are held against each other by how they miss the wanted ones, whatever the size of the figure: a
mistake that loses digits errs by about the same amount in every program, but hardly ever by the same digits.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from judge.compare import AnyTarget, CountTarget, ParameterTarget
from judge.compare.outline import Outline

OTHER_ANSWER = 0.5  # both wrong, in different ways
OTHER_END = 0.7  # one of them ended without an answer: nobody knows what it would have been
OTHER_NUMBERS = 0.9  # errors of the same size in the same numbers; less for each power of ten between them
_A_POWER_OF_TEN = 0.1
_SAME = 0.05  # of the larger error: numbers that differ by less are the same
_CLOSE = 1e-3  # of the numbers themselves, where there is no error to compare with


def agreement(one: Outline, other: Outline, target: AnyTarget) -> float:
    """How alike they are; symmetric, and 1 for equal ones."""
    if one == other:
        return 1.0
    form, numbers = one
    if form != other[0]:
        ended = form.startswith(_ENDED) or other[0].startswith(_ENDED)
        return OTHER_END if ended else OTHER_ANSWER
    if form == "count":
        return OTHER_ANSWER
    wanted = wanted_numbers(target)
    if len(wanted) == len(numbers):
        return _by_errors(_largest(numbers, wanted), _largest(other[1], wanted), _largest(numbers, other[1]))
    scale = max(map(abs, (*numbers, *other[1])), default=0.0)
    return 1.0 if _largest(numbers, other[1]) <= _CLOSE * scale else OTHER_END


_ENDED = ("raised ", "stopped ")


def wanted_numbers(target: AnyTarget) -> tuple[float, ...]:
    """The numbers of the right answer, correctly rounded."""
    if isinstance(target, CountTarget):
        return () if target.value is None else (float(target.value),)
    if isinstance(target, ParameterTarget):
        return () if target.t is None else (target.t[2],)
    return tuple(number[2] for point in target.points for number in point)


def _largest(numbers: Sequence[float], others: Sequence[float]) -> float:
    """The largest difference of two numbers in the same place."""
    return max((abs(x - y) for x, y in zip(numbers, others, strict=True)), default=0.0)


def _by_errors(one: float, other: float, between: float) -> float:
    """From the two errors and the difference between the answers."""
    if between <= _SAME * max(one, other):
        return 1.0
    if not (one > 0.0 and other > 0.0 and math.isfinite(one) and math.isfinite(other)):
        return OTHER_ANSWER
    powers = abs(math.log10(one) - math.log10(other))
    return max(OTHER_ANSWER, OTHER_NUMBERS - _A_POWER_OF_TEN * powers)
