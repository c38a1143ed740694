"""`int`: a whole number; `integer` as a parameter."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cached_property
from typing import Any

from judge.values.decode import Fault, near, number, show
from judge.values.likeness import Outline, Usual
from judge.values.lines import Tokens
from judge.values.outcome import UNMEASURED, Outcome, Place, Unreadable
from judge.values.plain import PlainType, integer_of, number_fault
from judge.values.type import NOTHING_MEASURED, Check, Draws, ExactOf, Number, Question, Quick, Raw, Target


class IntType(PlainType):
    """An int: no bool, and no float that is whole; `least` bounds a parameter from below in any case."""

    is_parameter = True
    noun = "an int"
    plural = "ints"
    annotation = "int"

    def __init__(self, *, least: int | None = None) -> None:
        self.text = "int"
        self.least = least

    @cached_property
    def check(self) -> Check:
        """As that of every type; this one is asked most often."""
        explained = self._explained

        def check(raw: Raw, target: Target, exact: ExactOf) -> Outcome:
            if type(raw) is int and raw == target:
                return UNMEASURED
            return explained(raw, target, exact)

        return check

    @cached_property
    def quick(self) -> Quick:
        """Whether they are equal."""
        return lambda raw, target: NOTHING_MEASURED if type(raw) is int and raw == target else None

    def why_not(self, value: Any) -> str | None:
        """Exactly an int."""
        return None if type(value) is int else f"{value!r} where an int is meant"

    def read(self, raw: Raw, question: Question, place: Place) -> Any:
        """An int of any size."""
        given = number(raw)
        if isinstance(given, Fault):
            raise Unreadable(given.where(f"{place.name() or self.noun} is meant"))
        if not isinstance(given, int):
            meant = f"{place.name() or self.noun} is meant"
            name = "float" if isinstance(given, float) else "number"
            more = " as an int" if place.name() else ""
            raise Unreadable(f"the {name} {show(raw)} where {meant}{more}")
        return given

    def take(self, tokens: Tokens) -> Raw:
        """A plain integer."""
        return tokens.integer(tokens.meant if tokens.whole else self.noun)

    def wanted_one(self, target: Target) -> str:
        """In full, unless it is absurdly long."""
        return show(target)

    def asserts_one(self, what: str, target: Target) -> Iterator[str]:
        """A bool or a float may be equal to an int."""
        yield f"{what} == {target} and not isinstance({what}, (bool, float))"

    def form(self, value: Any, *, target: bool = False) -> str:
        """An int is a count of something."""
        return "count"

    def flat(self, value: Any, *, target: bool = False) -> Iterator[float]:
        """The double next to it."""
        yield near(value)

    def kind(self, given: Outline, right: Outline, usual: Usual) -> str:
        """Another int; where few are usual, one that is none of them stands for having no answer."""
        form, numbers = given
        unusual = not numbers or (usual.few and numbers[0] not in usual.few)
        if form in ("count", "type float") and unusual:
            return "sentinel"
        return f"{numbers[0]:.0f}" if form == "count" else form

    # -- values of parameters ------------------------------------------------------------------------

    def fault(self, name: str, value: Any) -> str | None:
        """Exactly an int."""
        if type(value) is float:
            return f"{name} has the float {value!r} where an int is meant"
        return number_fault(name, value)

    def outside(self, value: Any, low: Fraction | int, high: Fraction | int) -> tuple[Any, Any, Any] | None:
        """Its own bound counts too."""
        if self.least is not None and low < self.least:
            low = self.least
        return None if low <= value <= high else (value, low, high)

    def value_from(self, token: str) -> Any:
        """An int as `repr` writes it."""
        value = integer_of(token)
        if value is None:
            raise ValueError(f"no int: {token[:40]!r}")
        return value

    def simple(self, draw: Draws, number: Callable[[bool], Number], *, positive: bool) -> Any:
        """The next simple number."""
        return int(number(positive or (self.least is not None and self.least >= 0)))


TYPE = IntType
