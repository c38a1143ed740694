"""What a type is, and what an atom is asked; a new atom is a file of a pack that derives from `Atom`."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from functools import cached_property
from pathlib import Path
from typing import Any, Protocol, Self

from judge.values.answers import NO_WORDS, Exact, Real, Tolerance, Words
from judge.values.wire import (
    Raw,
    Tokens,
    Unreadable,
    fault,
    quoted,
    show,
)

Number = int | float
Value = Any  # an answer that was read, or a parameter's
Target = Any
Leaf = Callable[[], tuple[Real, Tolerance]]  # an exact number and its tolerance
Quick = Callable[[Raw, Target], float | None]

NOTHING = -1.0  # where nothing is measured in ulps
COORDINATES = ("x", "y", "z")
LONGEST = 20_000  # items of all levels, where the type sets no bound above that
MANY_LENGTHS = 1000  # of a list without a bound


class Draws(Protocol):
    """Where the search for simple cases takes its choices from; `judge.data.draw.Draw` is one."""

    def integer(self, low: int, high: int) -> int:
        """An int from `low` to `high`."""
        ...


class Place:
    """Where in an answer something is: one step down from its parent.

    `step` is the index in the exact tree, `word` the name for a person ("point 2", "x"; "" for a step of the
    tree alone). A place is `alone` where it is the only one of its kind and need not be counted.
    """

    __slots__ = ("alone", "parent", "step", "word")

    def __init__(self, parent: Place | None, step: int, word: str, *, alone: bool = False) -> None:
        self.parent, self.step, self.word, self.alone = parent, step, word, alone

    def name(self, *, short: bool = False) -> str:
        """The place in words, "y of point 2"; a `short` name leaves out what is alone. Empty for the root."""
        return " of ".join(self._words(short=short))

    def told(self) -> str:
        """The place of a number, short; a coordinate of no point comes last: "part 2 of item 3: x"."""
        first, *rest = self._words(short=True) or [""]
        if first in COORDINATES and rest and not rest[0].startswith("point"):
            return f"{' of '.join(rest)}: {first}"
        return " of ".join([first, *rest])

    def prefix(self) -> str:
        """How a sentence about the whole of this place begins: "part 2 of item 3: ", nothing for the root."""
        name = self.name()
        return f"{name}: " if name else ""

    def _words(self, *, short: bool) -> list[str]:
        words = []
        place: Place | None = self
        while place is not None:
            if place.word and not (short and place.alone):
                words.append(place.word)
            place = place.parent
        return words


ROOT = Place(None, 0, "")


class Mismatch(Exception):  # noqa: N818 - it never reaches a person but as its text
    """An answer of the right form that is wrong: why, where, and the errors of the number that decided."""

    def __init__(
        self,
        message: str,
        where: str = "",
        errors: tuple[float | None, float | None, float | None] = (None, None, None),
    ) -> None:
        super().__init__(message)
        self.message, self.where, self.errors = message, where, errors


class Unfit(Exception):  # noqa: N818 - as above
    """An exact answer that is none of its type; its text says why."""


class Type:
    """A type of answers and of parameters. Types are equal if they are written alike; they never change."""

    text = ""  # as problem.toml has it
    words: Words = NO_WORDS  # of the problem, on the type of its whole answer
    folder: Path | None = None  # a pack's own types, without which the text may mean nothing

    is_answer = True
    is_parameter = True
    is_plain = True  # whether a submission receives a parameter's value as it is kept here
    settled = True  # whether an example shows the right answer, and not one of many that differ widely
    measured = False  # whether it holds real numbers, which have a tolerance
    optional = False  # whether the first token of a value may be `none`
    width: int | None = 1  # tokens on a line; None where that varies
    depth = 0  # levels of lists and tuples
    most = 1  # items of all levels in the longest answer, where the type bounds them
    lengths = 1  # that the longest of its lists may have, as many as are told apart
    noun = "a value"  # what is meant, "a number"
    plural = "values"  # "a list of numbers"
    one, several = "item", "items"  # what one and several of them in a list are called
    annotation = "object"  # in a stub
    variable = "answer"  # what a function's parameter of this type is called
    rounded = ""  # the expression that rounds `{}` for a doctest; empty where nothing is rounded

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"parse({self.text!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Type) and self._identity() == other._identity()

    def __hash__(self) -> int:
        return hash(self._identity())

    def __reduce__(self) -> tuple[Any, ...]:
        from judge.values.grammar import parse

        return parse, self._identity()

    def _identity(self) -> tuple[Any, ...]:
        return self.text, self.folder, self.words

    @property
    def items(self) -> int:
        """How many items an answer is read with, right or wrong."""
        return max(LONGEST, self.most)

    def worded(self, words: Words) -> Self:
        """The same type with a problem's own words."""
        if words == self.words:
            return self
        other = copy(self)
        other.words = words
        return other

    @cached_property
    def quick(self) -> Quick:
        """Accepts the usual right answer and says how far off it is in ulps; None where one must look closer.

        NOTHING where there is nothing to be off. May raise TypeError or ValueError instead of None.
        """
        return lambda _raw, _target: None

    def aliases(self) -> Mapping[str, str]:
        """The names that `annotation` uses beside Python's own, with what they stand for."""
        return {}


# -- atoms -------------------------------------------------------------------------------------------------


class Atom(Type):
    """Values of one piece, right if they equal the wanted one: target, exact answer and value are the same.

    A type of this kind says which values there are (`why_not`), how one arrives as JSON (`value_of`, `sent`)
    and how it is written as a token (`text_of`, `value_from`).
    """

    samples: Sequence[Any] = ()  # a few values, the simplest first; without any, no parameter is of this type
    least: int | None = None  # a bound from below of a parameter, in any case

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

    def sent(self, value: Any) -> Raw:
        """The JSON in which a submission's value arrives: what `value_of` reads."""
        return value

    def text_of(self, value: Any) -> str:
        """The value as a token, without blanks."""
        return str(value)

    def value_from(self, token: str) -> Any:
        """The value of a token; raises ValueError."""
        raise NotImplementedError

    # -- answers

    def aim(self, exact: Exact, tolerance: Tolerance) -> Target:
        """What answers are held against; raises Unfit."""
        wrong = self.why_not(exact)
        if wrong:
            raise Unfit(wrong)
        return exact

    def read(self, raw: Raw, place: Place, noun: str) -> Value:
        """The value that `raw` stands for; raises Unreadable. `noun` is what the whole answer may be."""
        try:
            return self.value_of(raw)
        except ValueError:
            name = place.name()
            meant = f"{self.noun} is meant{f' for {name}' if name else ''}"
            raise Unreadable(fault(raw).where(meant)) from None

    def off(self, value: Value, target: Target, leaf: Leaf) -> float | None:
        """How many ulps the value is off, NOTHING where that is not measured; None where it is wrong."""
        return NOTHING if value == target else None

    def why(self, value: Value, target: Target, words: Words, place: Place) -> Mismatch:
        """Why a value that is wrong is so."""
        return unequal(self, value, self.shown_target(target), place)

    def take(self, tokens: Tokens, meant: str) -> Raw:
        """The answer that the next token holds, as JSON; raises Unreadable."""
        token = tokens.next()
        try:
            return self.sent(self.value_from(token))
        except ValueError:
            raise Unreadable(f"{quoted(token)} where {meant} is meant") from None

    def token(self, target: Target) -> str:
        """The token that a perfect program prints."""
        return self.text_of(target)

    def shown(self, raw: Raw) -> str:
        """An answer, as JSON or read, as a person would write it, bounded whatever its shape."""
        return show(raw)

    def shown_target(self, target: Target) -> str:
        """The wanted answer as a person would write it in Python."""
        return repr(target)

    def exact_text(self, exact: Exact) -> Any:
        """An exact answer as JSON."""
        return exact

    def accepted(self, target: Target) -> Any:
        """What is accepted, as JSON."""
        return target

    def asserts(self, what: str, target: Target) -> str:
        """A Python condition on the expression `what` that holds exactly for a right answer."""
        return f"{what} == {target!r}"

    def form(self, value: Any) -> str:
        """The form of an answer, or of a target, in its outline."""
        return f"{type(self).__name__.removesuffix('Type').lower()} {self.text_of(value)}"

    def double(self, value: Any, *, target: bool) -> float | None:
        """The number of an answer, or of a target, in its outline."""
        return None

    # -- parameters

    def fault(self, name: str, value: Any) -> str | None:
        """What is wrong with a parameter's value, for a person, or None."""
        wrong = self.why_not(value)
        return f"{name} has {wrong}" if wrong else None

    def simple(self, draw: Draws, number: Callable[[bool], Number], *, positive: bool) -> Value:
        """A simple value: `number(positive)` gives its numbers, `positive` says that none may be negative."""
        return self.samples[draw.integer(0, len(self.samples) - 1)]

    def round(self, value: Value) -> Value:
        """What the expression `rounded` makes of a value."""
        return value


def unequal(type_: Type, value: Value, wanted: str, place: Place) -> Mismatch:
    """The sentence about a value that is simply another one."""
    given = type_.shown_target(value) if isinstance(type_, Atom) and value is not None else show(value)
    return Mismatch(f"{place.prefix()}{wanted} wanted, {given} given", place.name())
