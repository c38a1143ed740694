"""Proving a case: its shape, its bounds and its promise, with nothing rounded."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from judge.errors import ProblemError
from judge.problem import Case, Problem
from judge.problem.declare import InvalidCase
from judge.values import parameters
from judge.values.base import Number

if TYPE_CHECKING:
    from judge.values.answers import Exact


class Proof(NamedTuple):
    """What proving a case came to: what is wrong with it, in words for a person, or else its exact answer."""

    fault: str | None
    answer: Any = None


class Validator:
    """What a problem's case must be. A fault is said in words for a person."""

    def __init__(self, problem: Problem, solve: Callable[..., Exact]) -> None:
        self._parameters = problem.parameters
        self._bounds = [(_simple(each.low), _simple(each.high)) for each in problem.parameters]
        self._fine = [
            (place, each.type, least_double(each.smallest))
            for place, each in enumerate(problem.parameters)
            if each.smallest
        ]
        self._solve = solve

    def shape(self, case: Any) -> str | None:
        """Whether the case is a tuple of values of the parameters' types, its numbers finite."""
        if type(case) is not tuple or len(case) != len(self._parameters):
            return f"a case must be a tuple of {len(self._parameters)} arguments"
        for parameter, value in zip(self._parameters, case, strict=True):
            if fault := parameters.fault(parameter.type, parameter.name, value):
                return fault
        return None

    def bounds(self, case: Case) -> str | None:
        """Whether every number of a well-shaped case lies within its parameter's bounds, none too small."""
        for parameter, (low, high), value in zip(self._parameters, self._bounds, case):  # noqa: B905  # as above
            found = parameters.outside(parameter.type, value, low, high)
            if found is not None:
                number, low, high = found
                return f"{parameter.name} has {number!r}, outside {_text(low)} to {_text(high)}"
        for place, type_, smallest in self._fine:
            for number in parameters.reals(type_, case[place]):
                if number and -smallest < number < smallest:
                    parameter = self._parameters[place]
                    least = float(parameter.smallest)
                    return f"{parameter.name} has {number!r}, nearer to 0 than {least:g} but not 0"
        return None

    def promise(self, case: Case) -> Proof:
        """Whether a case within the bounds keeps the statement's promise; it is solved here, once."""
        try:
            return Proof(None, self._solve(*case))
        except InvalidCase as broken:
            return Proof(str(broken).removesuffix("."))

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


def _simple(bound: Fraction) -> int | Fraction:
    """An int where it is one: Python compares ints with ints and floats exactly, and much faster."""
    return bound.numerator if bound.denominator == 1 else bound


def least_double(bound: Fraction) -> float:
    """The least double that is not below the bound: a double is not below the one just when it is not below
    the other."""
    nearest = float(bound)
    return nearest if nearest >= bound else math.nextafter(nearest, math.inf)


def _text(bound: Number | Fraction) -> str:
    text = str(bound)
    return text if len(text) <= 24 else f"{text[:4]}… ({len(text.lstrip('-'))} digits)"
