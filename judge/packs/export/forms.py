"""Types and exact answers as JSON, in the form that the validators of a package read.

An answer's form is written at the top of validators/output_validator.py, a parameter's at the top of
validators/input_validator.py. Both are made by composition: a type that a pack brings itself has none.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from judge.exact import Surd
from judge.problem import Parameter, Problem, Tolerance
from judge.values.answers import AnyOf, Exact, Judged, exact_ends
from judge.values.atoms import IntType, NumberType, RealType, Type, WordType
from judge.values.types import ArrayType, ListType, OptionalType, TupleType

Form = list[Any]


class NoForm(Exception):  # noqa: N818 - a reason
    """Why a problem cannot be a package, in a few words."""


def form_of(type_: Type, within: Parameter | None = None) -> Form:
    """The form of an answer, or `within` a parameter, with the bounds of its numbers. Raises NoForm."""
    kind = type(type_)
    if isinstance(type_, NumberType) and (kind is RealType or kind is IntType):
        return ["real" if kind is RealType else "int", *(_bounds(type_, within) if within else [])]
    if isinstance(type_, WordType) and kind is WordType:
        return ["word", list(type_.samples)] if within else ["word"]
    if isinstance(type_, TupleType):
        return ["tuple", [form_of(part, within) for part in type_.made_of]]
    if isinstance(type_, OptionalType):
        return ["optional", form_of(type_.inner, within)]
    if isinstance(type_, ArrayType):
        raise NoForm(f"a line holds no {type_.text}")
    if isinstance(type_, ListType) and kind is ListType:
        return ["list", form_of(type_.item, within), type_.low, type_.high]
    raise NoForm(f"a package knows no type {type_.text}")


def _bounds(type_: NumberType, parameter: Parameter) -> Iterator[list[int]]:
    """Low, high and the smallest, each as numerator and denominator; some types have bounds of their own."""
    low = parameter.low if type_.low is None else max(parameter.low, Fraction(type_.low))
    high = parameter.high if type_.high is None else min(parameter.high, Fraction(type_.high))
    for bound in (low, high, parameter.smallest):
        yield list(bound.as_integer_ratio())


def accepted_form(type_: Type, exact: Exact, tolerance: Tolerance) -> Any:
    """What is accepted for an exact answer. Raises NoForm."""
    if isinstance(exact, AnyOf):
        return {"any": [accepted_form(type_, each, tolerance) for each in exact.answers]}
    if isinstance(exact, Judged):
        raise NoForm("no table says which of its answers are right: problem.py decides")
    if isinstance(type_, OptionalType):
        return None if exact is None else accepted_form(type_.inner, exact, tolerance)
    if isinstance(type_, TupleType):
        return [accepted_form(part, each, tolerance) for part, each in zip(type_.made_of, exact, strict=True)]
    if isinstance(type_, ListType):
        return [accepted_form(type_.item, each, tolerance) for each in exact]
    if isinstance(type_, RealType):
        return _ends(*exact_ends(exact, tolerance))
    return exact


def _ends(low: Surd, high: Surd) -> list[int]:
    """Both ends over one denominator and one radicand; three ints where they are rational."""
    assert low.d == high.d or not (low.q and high.q)
    mine, its = high.s, low.s  # what each is multiplied by
    if low.s == high.s:
        mine = its = 1
    ends = [low.p * mine, low.q * mine, high.p * its, high.q * its]
    s = low.s * mine
    return [*ends, low.d or high.d, s] if low.q or high.q else [ends[0], ends[2], s]


def check_forms(problem: Problem) -> None:
    """Raises NoForm where a problem cannot be a package, as far as its toml tells."""
    if problem.talks:
        raise NoForm("its programs are talked with")
    if problem.formatted:
        raise NoForm("its programs have a format of their own")
    if problem.growth is not None:
        raise NoForm("a package cannot measure how the time grows")
    if any(group.size is not None for group in problem.groups):
        raise NoForm("its cases are too large for a line")
    form_of(problem.answer)
    for parameter in problem.parameters:
        form_of(parameter.type, parameter)
