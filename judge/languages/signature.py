"""A problem's function as another language is told of it."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from judge.values.atoms import IntType, Type
from judge.values.types import atoms

if TYPE_CHECKING:
    from judge.values.calls import Method

_LONG = 1 << 63


class Signature(NamedTuple):
    """What a driver is made from: the function's name in the problem, its parameters, its answer's type.

    With `methods` it is a class, and the parameters are its constructor's. `is_run` says whether a program
    can be asked in its place.
    """

    entry: str
    parameters: tuple[tuple[str, Type], ...]  # names and types
    answer: Type
    big: bool = False  # whether a parameter's integers need more than 64 bits
    methods: tuple[Method, ...] = ()
    is_run: bool = True


class _Named(Protocol):
    @property
    def name(self) -> str: ...
    @property
    def type(self) -> Any: ...
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
    @property
    def methods(self) -> bool: ...
    @property
    def formatted(self) -> bool: ...


def signature_of(problem: _Declared) -> Signature:
    """The signature of a problem's function, or class."""
    own = problem.parameters[: -1 if problem.methods else None]
    methods: tuple[Method, ...] = problem.parameters[-1].type.methods if problem.methods else ()
    bounds = [bound for each in own if not each.type.measured for bound in (each.low, each.high)]
    taken = [atom for method in methods for _, type_ in method.takes for atom in atoms(type_)]
    bounds += [
        Fraction(bound or 0) for each in taken if isinstance(each, IntType) for bound in (each.low, each.high)
    ]
    big = any(abs(bound) >= _LONG for bound in bounds)
    parameters = tuple((each.name, each.type) for each in own)
    is_run = problem.formatted or not problem.methods
    return Signature(problem.entry, parameters, problem.answer, big, methods, is_run)
