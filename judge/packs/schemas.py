"""Types and exact answers as JSON, in the form that the validators of a package read.

An answer's form is written at the top of validators/output_validator.py, a parameter's at the top of
validators/input_validator.py. Both are made by composition: a type that a pack brings itself has none.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import repeat
from typing import Any

from judge.exact import Surd
from judge.problem import Case, Parameter, Problem, Tolerance
from judge.problem.module import load_module
from judge.values.answers import AnyOf, Called, Exact, Judged, exact_ends
from judge.values.atoms import IntType, NumberType, RealType, Type
from judge.values.calls import ReturnType
from judge.values.letters import BoolType, TextType, WordType
from judge.values.types import DictType, ListType, OptionalType, TupleType

Form = list[Any]


class NotExportable(Exception):  # noqa: N818 - a reason
    """Why a problem cannot be a package, in a few words."""


def form_of(type_: Type, within: Parameter | None = None) -> Form:
    """The form of an answer, or of a parameter (`within`) with its numbers' bounds. Raises NotExportable."""
    if isinstance(type_, TupleType):
        return ["tuple", [form_of(part, within) for part in type_.made_of]]
    if isinstance(type_, OptionalType):
        return ["optional", form_of(type_.inner, within)]
    if isinstance(type_, DictType):
        return ["dict", form_of(type_.key, within), form_of(type_.value, within), type_.low, type_.high]
    if isinstance(type_, ReturnType):
        return ["returns", [each.answer and form_of(each.answer) for each in type_.methods]]
    kind = type(type_)  # of those that follow, what a pack derives from them may be written otherwise
    if isinstance(type_, NumberType) and kind in (RealType, IntType):
        own = [] if type_.low is None else [type_.low, type_.high]
        return ["real" if kind is RealType else "int", *(_bounds(type_, within) if within else own)]
    if isinstance(type_, WordType) and kind is WordType:
        return ["word", list(type_.samples)]
    if isinstance(type_, TextType) and kind is TextType:
        return ["text", type_.low, type_.high, "".join(sorted(type_.signs))]
    if isinstance(type_, ListType) and kind is ListType:
        return ["list", form_of(type_.item, within), type_.low, type_.high]
    if kind is BoolType:
        return ["bool"]
    raise NotExportable(f"a package knows no type {type_.text}")


def _bounds(type_: NumberType, parameter: Parameter) -> Iterator[list[int]]:
    """Low, high and the smallest, each as numerator and denominator; some types have bounds of their own."""
    low = parameter.low if type_.low is None else max(parameter.low, Fraction(type_.low))
    high = parameter.high if type_.high is None else min(parameter.high, Fraction(type_.high))
    for bound in (low, high, parameter.smallest):
        yield list(bound.as_integer_ratio())


def accepted_form(
    type_: Type, exact: Exact, tolerance: Tolerance, case: Case = (), at: tuple[int, ...] = ()
) -> Any:
    """What is accepted for an exact answer, `at` that place of the whole one. Raises NotExportable."""

    def parts(types: Iterable[Type], found: Iterable[Exact]) -> list[Any]:
        pairs = enumerate(zip(types, found, strict=False))
        return [accepted_form(part, each, tolerance, case, (*at, place)) for place, (part, each) in pairs]

    if isinstance(exact, AnyOf):
        return {"any": parts(repeat(type_), exact.answers)}
    if isinstance(exact, Judged):
        return {"judged": exact.group, "case": repr(case), "at": at}
    if isinstance(type_, OptionalType):
        return None if exact is None else accepted_form(type_.inner, exact, tolerance, case, at)
    if isinstance(type_, TupleType):
        return parts(type_.made_of, exact)
    if isinstance(type_, ListType):
        return parts(repeat(type_.item), sorted(exact.items()) if isinstance(exact, dict) else exact)
    if isinstance(type_, ReturnType):
        return [[each.method, _returned(type_, each, tolerance)] for each in exact]
    if isinstance(type_, RealType):
        return _ends(*exact_ends(exact, tolerance))
    return exact


def _ends(low: Surd, high: Surd) -> list[int]:
    """Both ends over one denominator and one radicand; three ints where they are rational."""
    assert low.d == high.d or not (low.q and high.q)
    mine, its = (1, 1) if low.s == high.s else (high.s, low.s)  # what each is multiplied by
    a, b, c, d, s = low.p * mine, low.q * mine, high.p * its, high.q * its, low.s * mine
    return [a, b, c, d, low.d or high.d, s] if low.q or high.q else [a, c, s]


def _returned(type_: ReturnType, called: Called, tolerance: Tolerance) -> Any:
    """What is accepted of one of several calls in a row."""
    if isinstance(called.answer, Judged):
        raise NotExportable("no table says which answers of its methods are right: problem.py decides")
    answer = type_.methods[called.method].answer
    return answer and accepted_form(answer, called.answer, tolerance)


def whole_output(problem: Problem) -> str:
    """How a whole output is one answer: by its "tokens", as FORMAT "read"s it, a "talk"; empty: a line is."""
    if not problem.formatted:
        return ""
    if problem.talks:
        return "talk"
    own = load_module(problem).format
    return "read" if own and own.read else "tokens"


def check_forms(problem: Problem) -> None:
    """Raises NotExportable where a problem cannot be a package, as far as its types tell."""
    if problem.methods and whole_output(problem) != "read":
        lacks = "its FORMAT read and show" if problem.formatted else "it a FORMAT"
        raise NotExportable(f"a class has no form for programs; give {lacks}")
    if not problem.talks:
        form_of(problem.answer)
    if problem.talks or not problem.formatted:
        for parameter in problem.parameters:
            form_of(parameter.type, parameter)


def is_judged(accepted: Any) -> bool:
    """Whether what is accepted is for the problem's own checker to say."""
    if isinstance(accepted, dict):
        return "judged" in accepted or any(map(is_judged, accepted["any"]))
    return isinstance(accepted, list) and any(map(is_judged, accepted))
