"""Simple figures with one number far larger than the rest, at sizes where something changes.

A threshold, a precision or an overflow of a program shows where one number is long and all others are 0 or 1.
So that number is tried alone:

    10^k          every power up to the bound, in every place
    between them  a few sizes in the simplest figures
    its windows   between two powers where the right answer changes, or the promise ends, the border is
                  found by halving: beside it lie the cases that only a narrow threshold gets wrong

All of it is asked of the problem's own reference; the submission is called on the cases alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise, product

from judge.problem import Case, Problem
from judge.problem.model import Parameter
from judge.values.tuples import is_pair

State = Callable[[Case], str]  # what the right answer to a case is, roughly; "" for a case that is none

_MOST_LAYOUTS = 200
_MEASURED_BOUND = 10**9  # doubles: beyond it other rungs look, in other units
_BETWEEN = (15, 30, 70)  # tenths of a power
_FROM_THE_BORDER = (0, 1, 2, 5, 10, 20, 50, 100, 200, 400)  # thousandths


class Layout:
    """Small numbers everywhere but in one place."""

    def __init__(self, parameters: Sequence[Parameter], numbers: Sequence[int], place: int) -> None:
        self._parameters = parameters
        self._numbers = numbers
        self._place = place

    @property
    def plain(self) -> bool:
        """Whether at most one of the small numbers is 1."""
        return sum(self._numbers) <= 1

    def case(self, far: int) -> Case:
        """The case with that number in the place."""
        numbers = iter([*self._numbers[: self._place], far, *self._numbers[self._place + 1 :]])
        return tuple(
            (next(numbers), next(numbers)) if is_pair(parameter.type) else next(numbers)
            for parameter in self._parameters
        )


def layouts(problem: Problem) -> list[Layout]:
    """The layouts of a problem of points and numbers; none where it has other parameters, or too many.

    A single number that may be negative, such as a centre's coordinate, is 0 in them, or
    large in a plain one.
    """
    parameters = problem.parameters
    if not _of_points_and_numbers(parameters):
        return []
    free: list[bool] = []  # for each number, whether it takes part
    for parameter in parameters:
        free += [True, True] if is_pair(parameter.type) else [parameter.low >= 0]
    if 2 ** (sum(free) - 1) * sum(free) > _MOST_LAYOUTS:
        return []
    found = []
    for place, taking_part in enumerate(free):
        kinds = [(0, 1) if taking and at != place else (0,) for at, taking in enumerate(free)]
        every = [Layout(parameters, numbers, place) for numbers in product(*kinds)]
        found += every if taking_part else [layout for layout in every if layout.plain]
    return found


def sizes(problem: Problem) -> list[int]:
    """The sizes between the powers of ten."""
    return [tens * tenths // 10 for tens in powers(problem)[1:-1] for tenths in _BETWEEN]


def powers(problem: Problem) -> list[int]:
    """The powers of ten up to what the parameters allow."""
    highest = min(int(parameter.high) for parameter in problem.parameters)
    if any(parameter.type.measured for parameter in problem.parameters):
        highest = min(highest, _MEASURED_BOUND)
    found = [1]
    while found[-1] * 10 <= highest:
        found.append(found[-1] * 10)
    return found


def windows(layout: Layout, tens: Sequence[int], state: State) -> Iterator[Case]:
    """The cases on both sides of every border that the layout crosses between two neighbours of `tens`."""
    states = [(far, state(layout.case(far))) for far in tens]
    for (low, before), (high, after) in pairwise(states):
        if before == after:
            continue
        last = _border(low, high, lambda far, wanted=before: state(layout.case(far)) == wanted)  # type: ignore[misc]
        first = _border(low, high, lambda far, other=after: state(layout.case(far)) != other)  # type: ignore[misc]
        for thousandths in _FROM_THE_BORDER:
            for far in (last * (1000 - thousandths) // 1000, (first + 1) * (1000 + thousandths) // 1000):
                for rounded in _fewer_digits(far):
                    if low <= rounded <= high:
                        yield layout.case(rounded)


def _border(low: int, high: int, holds: Callable[[int], bool]) -> int:
    """The last number from `low` on for which something holds that does not for `high`."""
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low


def _fewer_digits(number: int) -> list[int]:
    """The number, and the ones near it that have two digits and zeros."""
    unit = 10 ** max(0, len(str(number)) - 2)
    below = number // unit * unit
    return [number, below, below + unit]


def _of_points_and_numbers(parameters: Sequence[Parameter]) -> bool:
    points = [is_pair(parameter.type) for parameter in parameters]
    return any(points) and all(
        is_point or parameter.type.annotation in ("float", "int")
        for is_point, parameter in zip(points, parameters, strict=True)
    )
