"""Making a failing case simpler, value by value: fewer digits, smaller numbers, equal ones kept equal.

The problem's topic is asked first for cases that are simpler as a whole. Then each round offers all single
step from the best case so far, has them called in one batch, and goes on from the simplest that still fails,
until none does. Then two steps are taken at once, as where a text and an int only fail together.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from heapq import nsmallest
from itertools import chain, combinations, islice
from math import gcd, lcm

from judge.diagnose.candidates import items_of, measure, numbers_of, sized, texts_of, with_numbers
from judge.diagnose.trial import FailingCase, Trial
from judge.problem import Case, Group, Problem
from judge.values import parameters
from judge.values.atoms import Number

_ROUNDS = 60
_MOST = 600  # candidates of a round, the simplest first
_PAIRS = 20_000  # of two steps at once that are looked at, and called
_PAIRS_CALLED = 2_000
_WORK = 1_000_000  # values that the candidates of a round may have together: a list of hundreds has few
_HUGE = 400  # bits, beyond which numbers are only cut


def simplified(trial: Trial, start: FailingCase, group: Group) -> FailingCase:
    """The simplest failing case that steps from `start` lead to, judged under `group`'s tolerance."""
    simpler, best = trial.module.hooks.simpler, start
    if simpler is not None:
        best = _better(trial, best, group, simpler(trial.problem, start.case))
    problem = trial.problem
    for _ in range(_ROUNDS):
        after = _better(trial, best, group, chain(fewer(problem, best.case), steps(best.case)))
        if after is best and sized(problem):
            after = _better(trial, best, group, islice(_both(problem, best.case), _PAIRS), _PAIRS_CALLED)
        if after is best or trial.budget.spent:
            return after
        best = after
    return best


def rounded(trial: Trial, best: FailingCase, group: Group) -> FailingCase:
    """The case with long numbers as round as they can be: as many digits, most of them 0."""
    for _ in range(_ROUNDS):
        numbers = list(numbers_of(best.case))
        cases = [
            _replaced(best.case, numbers, dict.fromkeys(places, other))
            for places in _equal(numbers)
            for other in _rounder(numbers[places[0]])
        ]
        found = trial.simplest([case for case in cases if measure(case)[0] <= best.measure[0]], group)
        if found is None:
            return best
        best = found
    return best


def _rounder(signed: Number) -> Iterator[int]:
    """Integers near a long one, of as many digits, of which more are final zeros."""
    text = str(abs(signed)) if isinstance(signed, int) and abs(signed).bit_length() <= _HUGE else ""
    for kept in range(1, len(text.rstrip("0"))):
        unit = 10 ** (len(text) - kept)
        yield from (int(text) // unit * unit, (int(text) // unit + 1) * unit)


def _better(
    trial: Trial, best: FailingCase, group: Group, cases: Iterable[Case], called: int = _MOST
) -> FailingCase:
    letters = sum(len(each) for each in texts_of(best.case) if isinstance(each, str))
    most, size = max(_MOST, _WORK // (1 + items_of(best.case) + letters)), best.measure
    simpler = {hash(repr(case)): case for case in islice(cases, most) if measure(case) < size}
    return trial.simplest(nsmallest(called, simpler.values(), key=measure), group) or best


def fewer(problem: Problem, case: Case) -> Iterator[Case]:
    """The case with a shorter list, or a shorter or simpler text, in one place."""
    for place, (parameter, value) in enumerate(zip(problem.parameters, case, strict=True)):
        most = max(_MOST, _WORK // (1 + len(value))) if isinstance(value, str) else _MOST
        for other in islice(parameters.simpler(parameter.type, value), most):
            yield (*case[:place], other, *case[place + 1 :])


def _both(problem: Problem, case: Case) -> Iterator[Case]:
    """The case with a shorter or simpler text or list, and beside it a smaller number, or another such."""
    for one in fewer(problem, case):
        numbers = list(numbers_of(one))
        for place, value in enumerate(numbers):
            for smaller in {0, 1, abs(value) // 2, abs(value) - 1}:
                yield _replaced(one, numbers, {place: smaller})
        yield from fewer(problem, one)


def steps(case: Case) -> Iterator[Case]:
    """The case with one thing changed: a number wherever it stands, two by as much, or all numbers."""
    numbers = list(numbers_of(case))
    yield from _all_changed(case, numbers)
    for places in _equal(numbers):
        value = numbers[places[0]]
        for smaller in _smaller(value):
            yield _replaced(case, numbers, dict.fromkeys(places, smaller))
            for place in places if len(places) > 1 else ():
                yield _replaced(case, numbers, {place: smaller})
    for place in range(len(numbers)):
        for other in {abs(number) for number in numbers if number}:
            yield with_numbers(case, [*numbers[:place], other, *numbers[place + 1 :]])
    yield from _pairs(case, numbers)


def _equal(numbers: list[Number]) -> list[list[int]]:
    """The places of equal magnitudes."""
    places: dict[Number, list[int]] = {}
    for place, value in enumerate(numbers):
        if value:
            places.setdefault(abs(value), []).append(place)
    return list(places.values())


def _smaller(signed: Number) -> Iterator[Number]:
    """Simpler magnitudes than that of a number."""
    value: int | float = abs(signed)
    yield from (0, 1, 2, 3)
    if isinstance(value, float):
        if value.is_integer() and value < 1e17:
            yield int(value)
        yield from (float(f"{value:.{kept}e}") for kept in range(16))
        yield from (1.0, 2.0, value / 2)
        if value < 1:  # nearer to 1 is simpler
            yield from (float(f"{value * factor:.0e}") for factor in (2, 10, 10**3, 10**6))
        return
    yield from _fewer_digits(value)


def _fewer_digits(value: int) -> Iterator[int]:
    if value.bit_length() > _HUGE:
        yield value >> 1
        return
    text = str(value)
    yield from (int(text[:kept]) for kept in range(1, len(text)))
    yield from _rounder(value)
    yield from (value // 2, max(0, value - 1))


def _pairs(case: Case, numbers: list[Number]) -> Iterator[Case]:
    """Two magnitudes changed by the same amount, so that their difference stays."""
    magnitudes = sorted({abs(number) for number in numbers if number})
    for low, high in islice(combinations(magnitudes, 2), 40):
        for smaller in islice(_smaller(low), 24):
            change = Fraction(smaller) - Fraction(low)
            larger = Fraction(high) + change
            if larger < 0:
                continue
            other = int(larger) if isinstance(high, int) and larger.denominator == 1 else float(larger)
            becomes = {low: smaller, high: other}
            changed = {at: becomes[abs(each)] for at, each in enumerate(numbers) if abs(each) in becomes}
            yield _replaced(case, numbers, changed)


def _all_changed(case: Case, numbers: list[Number]) -> Iterator[Case]:
    """Every number divided, made an integer, or cut to so many digits."""
    if all(isinstance(number, int) for number in numbers):
        common = gcd(*(int(number) for number in numbers))
        for divisor in ([common] if common > 1 else []) + [2, 10]:
            yield with_numbers(case, [int(number) // divisor for number in numbers])
        return
    if all(float(number).is_integer() and abs(number) < 1e17 for number in numbers):
        yield with_numbers(case, [int(number) for number in numbers])
    yield with_numbers(case, [0 if number == 0 else number for number in numbers])
    unit = _common_unit(numbers)
    if unit is not None:
        whole = [int(Fraction(number) / unit) for number in numbers]
        yield with_numbers(case, list(whole))
        for exponent in range(-15, 10):
            scale = Fraction(10) ** exponent
            if Fraction(1, 32) < scale / unit < 32:
                yield with_numbers(case, [float(value * scale) if value else 0 for value in whole])
    for kept in range(6):
        yield with_numbers(
            case, [each if isinstance(each, int) else float(f"{each:.{kept}e}") for each in numbers]
        )


def _common_unit(numbers: list[Number]) -> Fraction | None:
    """The largest unit of which all numbers are multiples, if they are then of few digits."""
    parts = [abs(Fraction(number)) for number in numbers if number]
    if not parts:
        return None
    unit = Fraction(gcd(*(each.numerator for each in parts)), lcm(*(each.denominator for each in parts)))
    return unit if max(parts) / unit < 10**9 else None


def _replaced(case: Case, numbers: list[Number], changed: dict[int, Number]) -> Case:
    """The case with other magnitudes in some places, the signs kept."""
    values = list(numbers)
    for place, value in changed.items():
        values[place] = -value if numbers[place] < 0 and value else value
    return with_numbers(case, values)
