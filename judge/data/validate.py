"""Proving a case: its shape, its bounds and its promise, with nothing rounded."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from judge.errors import ProblemError
from judge.problem import Case, Number, Parameter, ParameterType, Problem

if TYPE_CHECKING:
    from judge.data.module import Solved

_POINTS = (ParameterType.POINT, ParameterType.INTEGER_POINT)
_INTEGERS = (ParameterType.INTEGER, ParameterType.INTEGER_POINT)


class Proof(NamedTuple):
    """What proving a case came to: what is wrong with it, in words for a person, or else its exact answer."""

    fault: str | None
    answer: Any = None


class Validator:
    """What a problem's case must be. A fault is said in words for a person."""

    def __init__(self, problem: Problem, solve: Callable[..., Solved]) -> None:
        self._parameters = problem.parameters
        self._bounds = [(_simple(each.low), _simple(each.high)) for each in problem.parameters]
        self._solve = solve

    def shape(self, case: Any) -> str | None:
        """Whether the case is a tuple of the parameters' types, its numbers finite ints and floats."""
        if type(case) is not tuple or len(case) != len(self._parameters):
            return f"a case must be a tuple of {len(self._parameters)} arguments"
        for parameter, value in zip(self._parameters, case, strict=True):
            if parameter.type in _POINTS:
                if type(value) is not tuple or len(value) != 2:
                    return f"{parameter.name} must be a pair of numbers, not {value!r}"
                numbers: tuple[Any, ...] = value
            else:
                numbers = (value,)
            for number in numbers:
                if fault := _number_fault(parameter, number):
                    return fault
        return None

    def bounds(self, case: Case) -> str | None:
        """Whether every number of a well-shaped case lies within its parameter's bounds."""
        for (low, high), value in zip(self._bounds, case):  # noqa: B905  # it has the parameters' shape
            if type(value) is tuple:
                x, y = value
                if not (low <= x <= high and low <= y <= high):
                    return self._outside(case)
            elif not low <= value <= high:  # type: ignore[operator]  # a number
                return self._outside(case)
        return None

    def _outside(self, case: Case) -> str:
        for parameter, (low, high), value in zip(self._parameters, self._bounds, case, strict=True):
            for number in value if isinstance(value, tuple) else (value,):
                if not low <= number <= high:
                    return f"{parameter.name} has {number!r}, outside {_text(low)} to {_text(high)}"
        raise AssertionError("some number is outside")

    def promise(self, case: Case) -> Proof:
        """Whether a case within the bounds keeps the statement's promise; it is solved here, once."""
        answer, broken = self._solve(*case)
        return Proof(broken) if broken else Proof(None, answer)

    def proof(self, case: Any) -> Proof:
        """The first thing that is wrong with the case, or its exact answer."""
        fault = self.shape(case) or self.bounds(case)
        return Proof(fault) if fault else self.promise(case)


def prove(validator: Validator, group: str, cases: Sequence[Case], where: str) -> None:
    """Prove every case of a group. Raises ProblemError with the first that fails."""
    for number, case in enumerate(cases, start=1):
        if fault := validator.proof(case).fault:
            raise ProblemError(
                f"case {number} of group {group!r} is invalid: {fault}",
                where=where,
                remedy="correct the builder, its parameters or the bounds",
            )


def _number_fault(parameter: Parameter, number: Any) -> str | None:
    """Exactly an int or a float: a bool or a subclass would not come back from the cache as it went in."""
    if type(number) is int:
        return None
    if type(number) is not float:
        return f"{parameter.name} has {number!r}, a {type(number).__name__}, where a number is meant"
    if parameter.type in _INTEGERS:
        return f"{parameter.name} has the float {number!r} where an int is meant"
    if not math.isfinite(number):
        return f"{parameter.name} has {number!r}, which is not finite"
    return None


def _simple(bound: Fraction) -> int | Fraction:
    """An int where it is one: Python compares ints with ints and floats exactly, and much faster."""
    return bound.numerator if bound.denominator == 1 else bound


def _text(bound: Number | Fraction) -> str:
    text = str(bound)
    return text if len(text) <= 24 else f"{text[:4]}… ({len(text.lstrip('-'))} digits)"
