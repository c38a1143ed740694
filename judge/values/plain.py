"""What ints, words and other atoms that are simply equal or not have in common, and their numbers' text."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from judge.values.decode import fault, shown
from judge.values.lines import Tokens
from judge.values.outcome import Mismatch, Place, Unfit, Unreadable
from judge.values.tolerance import Tolerance
from judge.values.tree import Exact
from judge.values.type import NOTHING_MEASURED, Draws, Number, Question, Quick, Raw, Target, Type

if TYPE_CHECKING:
    from judge.values.interval import Roots

FLOAT = re.compile(r"-?[0-9]{1,400}(\.[0-9]{1,400})?(e[+-]?[0-9]{1,3})?", re.ASCII)
_INTEGER = re.compile(r"-?(0|[1-9][0-9]{0,999})", re.ASCII)


class PlainType(Type):
    """Values that are right if they equal the wanted one. Target, exact answer and value are the same thing.

    A type of this kind says which values there are (`why_not`), how one arrives as JSON (`value_of`, `sent`)
    and how it is written as a token (`text_of`, `value_from`).
    """

    samples: Sequence[Any] = ()  # a few values, the simplest first; without any, no parameter is of this type

    @property
    def is_parameter(self) -> bool:  # type: ignore[override]
        """Whether simple values are known, which the search for simple cases needs."""
        return bool(self.samples)

    def why_not(self, value: Any) -> str | None:
        """Why a value is none of this type, "'up' where left or right is meant"; None where it is one."""
        raise NotImplementedError

    def value_of(self, raw: Raw) -> Any:
        """The value of what a submission sent, or of a worked example's literal; raises ValueError."""
        raise NotImplementedError

    def text_of(self, value: Any) -> str:
        """The value as a token, without blanks."""
        return str(value)

    def value_from(self, token: str) -> Any:
        """The value of a token; raises ValueError."""
        raise NotImplementedError

    # -- answers -------------------------------------------------------------------------------------

    def aimed(self, exact: Exact, tolerance: Tolerance, roots: Roots) -> Target:
        """Itself."""
        fault = self.why_not(exact)
        if fault:
            raise Unfit(fault)
        return exact

    @cached_property
    def quick(self) -> Quick:
        """Nothing: `read` is quick enough."""
        return lambda _raw, _target: None

    def read(self, raw: Raw, question: Question, place: Place) -> Any:
        """The value."""
        try:
            return self.value_of(raw)
        except ValueError:
            name = place.name()
            meant = f"{self.noun} is meant{f' for {name}' if name else ''}"
            raise Unreadable(fault(raw).where(meant)) from None

    def matched(self, value: Any, target: Target, question: Question, place: Place) -> float:
        """Nothing is measured."""
        if value == target:
            return NOTHING_MEASURED
        raise self._unequal(value, target, place)

    def missed(self, value: Any, target: Target, misses: list[Mismatch], place: Place) -> Mismatch:
        """All that are right are told."""
        return self._unequal(value, target, place)

    def _unequal(self, value: Any, target: Target, place: Place) -> Mismatch:
        message = f"{place.prefix()}{self.wanted(target)} wanted, {self.wanted(value)} given"
        return Mismatch(message, place.name())

    def take(self, tokens: Tokens) -> Raw:
        """The value of a token, in the form in which it is sent."""
        token = tokens.next()
        try:
            return self.sent(self.value_from(token))
        except ValueError:
            meant = tokens.meant if tokens.whole else self.noun
            raise Unreadable(f"{shown(token)} where {meant} is meant") from None

    def sent(self, value: Any) -> Raw:
        """The JSON in which a submission's value arrives: what `value_of` reads."""
        return value

    def printed_one(self, target: Target) -> Iterator[str]:
        """A token."""
        yield self.text_of(target)

    def wanted_one(self, target: Target) -> str:
        """As Python writes it."""
        return repr(target)

    def asserts_one(self, what: str, target: Target) -> Iterator[str]:
        """Equality."""
        yield f"{what} == {target!r}"

    def form(self, value: Any, *, target: bool = False) -> str:
        """The value is all there is."""
        return f"{type(self).__name__.removesuffix('Type').lower()} {self.text_of(value)}"

    def flat(self, value: Any, *, target: bool = False) -> Iterator[float]:
        """No numbers."""
        return iter(())

    # -- values of parameters ------------------------------------------------------------------------

    def fault(self, name: str, value: Any) -> str | None:
        """Whether it is a value."""
        fault = self.why_not(value)
        return f"{name} has {fault}" if fault else None

    def simple(self, draw: Draws, number: Callable[[bool], Number], *, positive: bool) -> Any:
        """Any of the samples."""
        return self.samples[draw.integer(0, len(self.samples) - 1)]

    def tokens(self, value: Any) -> Iterator[str]:
        """A token."""
        yield self.text_of(value)

    def from_tokens(self, tokens: Iterator[str]) -> Any:
        """The next token's value."""
        return self.value_from(next(tokens))


def integer_of(token: str) -> int | None:
    """The int that `repr` wrote, or None for any other text."""
    return int(token) if _INTEGER.fullmatch(token) else None


def number_fault(name: str, value: Any) -> str | None:
    """Why a parameter's value is no number, as a message says it; None for an int."""
    if type(value) is int:
        return None
    return f"{name} has {value!r}, a {type(value).__name__}, where a number is meant"
