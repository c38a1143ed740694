"""`T?`: a value of type T, or None."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cached_property
from itertools import chain
from typing import TYPE_CHECKING, Any

from judge.values.decode import shown
from judge.values.likeness import Outline, Usual
from judge.values.lines import Tokens
from judge.values.outcome import UNMEASURED, Mismatch, Outcome, Place, Unreadable, Words
from judge.values.rightness import accepts
from judge.values.tolerance import Tolerance
from judge.values.tree import Exact
from judge.values.type import (
    NOTHING_MEASURED,
    Check,
    Draws,
    ExactOf,
    Number,
    Question,
    Quick,
    Raw,
    Target,
    Type,
)

if TYPE_CHECKING:
    from judge.values.interval import Roots


class OptionalType(Type):
    """None, or what `inner` says."""

    optional = True
    may_begin_with_none = True

    def __init__(self, inner: Type) -> None:
        if inner.may_begin_with_none:
            raise ValueError("as text it does not say whether all of it is none or only its first part")
        self.inner = inner
        self.text = f"{inner.text}?"
        self.measured, self.settled = inner.measured, inner.settled
        self.is_buffer = inner.is_buffer
        self.is_parameter, self.is_plain = inner.is_parameter, inner.is_plain
        self.width = 1 if inner.width == 1 else None
        self.depth, self.most, self.lengths = inner.depth, inner.most, inner.lengths
        self.noun = f"{inner.noun} or None"
        self.plural, self.element = inner.plural, inner.element
        self.variable = inner.variable
        self.annotation = f"{inner.annotation} | None"
        self.rounded = f"None if {{0}} is None else {inner.rounded}" if inner.rounded else ""

    def aimed(self, exact: Exact, tolerance: Tolerance, roots: Roots) -> Target:
        """None, or the inner target."""
        return None if exact is None else self.inner.targeted(exact, tolerance, roots)

    @cached_property
    def check(self) -> Check:
        """As that of every type; None and ints are compared at once."""
        usual, explained = Type.check.func(self), self._explained  # type: ignore[attr-defined]
        if self.inner.text != "int":
            return usual  # type: ignore[no-any-return]

        def check(raw: Raw, target: Target, exact: ExactOf) -> Outcome:
            if (type(raw) is int or raw is None) and raw == target:
                return UNMEASURED
            return explained(raw, target, exact)

        return check

    @cached_property
    def quick(self) -> Quick:
        """Whether both are None, or the inner answer."""
        inner = self.inner.quick

        def quick(raw: Raw, target: Target) -> float | None:
            if raw is None or target is None:
                return NOTHING_MEASURED if raw is target else None
            return inner(raw, target)

        return quick

    def read(self, raw: Raw, question: Question, place: Place) -> Any:
        """None, or the inner value."""
        if raw is None:
            return None
        return self.inner.read(raw, question, place)

    def fits(self, value: Any, target: Target, question: Question, place: Place) -> bool:
        """Whether both are None, or the inner type says so."""
        if value is None or target is None:
            return value is target
        return accepts(self.inner, value, target, question, place)

    def matched(self, value: Any, target: Target, question: Question, place: Place) -> float:
        """Both None, or as the inner type has it."""
        if value is not None and target is not None:
            return self.inner.held(value, target, question, place)
        if value is target:
            return NOTHING_MEASURED
        if target is None:
            message = f"None wanted, {self.inner.shown(value)} given"
        elif place.parent is None and question.words.missing:
            name = f"{question.words.answer} = " if question.words.answer else ""
            message = f"None given, {question.words.missing}: {name}{self.inner.wanted(target)}"
        else:
            message = f"{self.inner.wanted(target)} wanted, None given"
        raise Mismatch(f"{place.prefix()}{message}", place.name())

    def missed(self, value: Any, target: Target, misses: list[Mismatch], place: Place) -> Mismatch:
        """As the inner type has it."""
        if value is not None:
            return self.inner.missed(value, target, misses, place)
        return Mismatch(f"{place.prefix()}{self.wanted(target)} wanted, None given", place.name())

    def take(self, tokens: Tokens) -> Raw:
        """`none`, or what the inner type takes."""
        ahead = tokens.ahead
        if ahead == "none":
            tokens.next()
            return None
        if ahead.lower() in {"none", "null"}:
            meant = tokens.meant if tokens.whole else self.hint(Words())
            raise Unreadable(f"{shown(ahead)} where {meant} is meant: write none in lower case")
        return self.inner.take(tokens)

    @property
    def lasting(self) -> Type:
        """The inner type."""
        return self.inner

    def hint(self, words: Words) -> str:
        """Or none."""
        return f"{self.inner.hint(words)} or none"

    def printed_one(self, target: Target) -> Iterator[str]:
        """`none`, or the inner tokens."""
        return iter(("none",)) if target is None else self.inner.printed(target)

    def wanted_one(self, target: Target) -> str:
        """None, or the inner text."""
        return "None" if target is None else self.inner.wanted(target)

    def shown(self, raw: Raw) -> str:
        """As the inner type shows it."""
        return "None" if raw is None else self.inner.shown(raw)

    def exact_text_one(self, exact: Exact) -> Any:
        """None, or the inner text."""
        return None if exact is None else self.inner.exact_text(exact)

    def accepted_one(self, target: Target) -> Any:
        """None, or what the inner type accepts."""
        return None if target is None else self.inner.accepted(target)

    def asserts_one(self, what: str, target: Target) -> Iterator[str]:
        """None is the only one of its kind."""
        if target is None:
            yield f"{what} is None"
        else:
            yield from self.inner.asserts(what, target)

    def form(self, value: Any, *, target: bool = False) -> str:
        """None has a form of its own."""
        return "none" if value is None else self.inner.form(value, target=target)

    def flat(self, value: Any, *, target: bool = False) -> Iterator[float]:
        """None has no numbers."""
        return iter(()) if value is None else self.inner.flat(value, target=target)

    def kind(self, given: Outline, right: Outline, usual: Usual) -> str:
        """As the inner type has it, which is told a right None, too."""
        return self.inner.kind(given, right, usual)

    # -- values of parameters ------------------------------------------------------------------------

    def fault(self, name: str, value: Any) -> str | None:
        """None is no fault."""
        return None if value is None else self.inner.fault(name, value)

    def outside(self, value: Any, low: Fraction | int, high: Fraction | int) -> tuple[Any, Any, Any] | None:
        """None is within all bounds."""
        return None if value is None else self.inner.outside(value, low, high)

    def reals(self, value: Any) -> Iterator[Number]:
        """None has none."""
        return iter(()) if value is None else self.inner.reals(value)

    def tokens(self, value: Any) -> Iterator[str]:
        """`none`, or the inner tokens."""
        return iter(("none",)) if value is None else self.inner.tokens(value)

    def from_tokens(self, tokens: Iterator[str]) -> Any:
        """What `tokens` wrote."""
        first = next(tokens)
        return None if first == "none" else self.inner.from_tokens(chain((first,), tokens))

    def listed(self, value: Any) -> Any:
        """None, or the inner value."""
        return None if value is None else self.inner.listed(value)

    def argument(self, value: Any) -> Any:
        """None, or the inner argument."""
        return None if value is None else self.inner.argument(value)

    def literal(self, value: Any) -> str:
        """None, or as the inner type writes it."""
        return "None" if value is None else self.inner.literal(value)

    def simpler(self, value: Any) -> Iterator[Any]:
        """None is simpler than anything."""
        if value is not None:
            yield None
            yield from self.inner.simpler(value)

    def round(self, value: Any) -> Any:
        """None stays."""
        return None if value is None else self.inner.round(value)

    def simple(self, draw: Draws, number: Callable[[bool], Number], *, positive: bool) -> Any:
        """None as often as not."""
        return self.inner.simple(draw, number, positive=positive) if draw.integer(0, 1) else None

    def aliases(self) -> Mapping[str, str]:
        """Those of the inner type."""
        return self.inner.aliases()
