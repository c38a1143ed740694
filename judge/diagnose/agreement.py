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
OTHER_SENTINEL = 0.9  # numbers that no case has for an answer, such as -1 and 99
OTHER_END = 0.7  # one of them ended without an answer: nobody knows what it would have been
OTHER_DIGITS = 0.9  # small errors of the same size in the same numbers; less for each power of ten between
_A_POWER_OF_TEN = 0.1
_SAME = 0.05  # of the larger error: numbers that differ by less are the same
_CLOSE = 1e-3  # of the largest number: an error that is smaller is one of digits


def agreement(one: Outline, other: Outline, target: AnyTarget) -> float:
    """How alike they are; symmetric, and 1 for equal ones."""
    if one == other:
        return 1.0
    form, numbers = one
    if form != other[0]:
        ended = form.startswith(_ENDED) or other[0].startswith(_ENDED)
        return OTHER_END if ended else OTHER_ANSWER
    if _is_sentinel(one, target) and _is_sentinel(other, target):
        return OTHER_SENTINEL
    if form == "count":
        return OTHER_ANSWER
    if len(numbers) != len(other[1]) or not all(map(math.isfinite, (*numbers, *other[1]))):
        return OTHER_ANSWER
    wanted = wanted_numbers(target)
    between = _largest(numbers, other[1])
    close = _CLOSE * max(map(abs, (*numbers, *other[1], *wanted)), default=0.0)
    if len(wanted) != len(numbers):  # as two points where one is wanted
        return 1.0 if between <= close else OTHER_END
    errors = _largest(numbers, wanted), _largest(other[1], wanted)
    if between <= _SAME * max(errors):
        return 1.0
    if min(errors) == 0.0 or max(errors) > close:
        return OTHER_ANSWER
    powers = abs(math.log10(errors[0]) - math.log10(errors[1]))
    return max(OTHER_ANSWER, OTHER_DIGITS - _A_POWER_OF_TEN * powers)


def _is_sentinel(given: Outline, target: AnyTarget) -> bool:
    """Whether a number stands for "none" that is no answer at all."""
    form, numbers = given
    if isinstance(target, CountTarget):
        return form == "count" and numbers[0] not in (0.0, 1.0, 2.0)
    return form == "number" and isinstance(target, ParameterTarget) and not target.t and numbers[0] < 0.0


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
