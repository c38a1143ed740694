"""A problem's function as another language is told of it."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple, Protocol

from judge.values.atoms import Type

_LONG = 1 << 63


class Signature(NamedTuple):
    """What a driver is made from: the function's name in the problem, its parameters, its answer's type."""

    entry: str
    parameters: tuple[tuple[str, Type], ...]  # names and types
    answer: Type
    big: bool = False  # whether a parameter's integers need more than 64 bits


class _Named(Protocol):
    @property
    def name(self) -> str: ...
    @property
    def type(self) -> Type: ...
    @property
    def low(self) -> Fraction: ...
    @property
    def high(self) -> Fraction: ...


class _Declared(Protocol):
    @property
    def entry(self) -> str: ...
    @property
    def answer(self) -> Type: ...
    @property
    def parameters(self) -> Sequence[_Named]: ...


def signature_of(problem: _Declared) -> Signature:
    """The signature of a problem's function."""
    parameters = tuple((each.name, each.type) for each in problem.parameters)
    big = any(
        max(abs(each.low), abs(each.high)) >= _LONG and _whole(each.type) for each in problem.parameters
    )
    return Signature(problem.entry, parameters, problem.answer, big)


def _whole(type_: Type) -> bool:
    return not type_.measured
