"""What a type is, and the atoms of numbers; `judge.values.letters` has words, texts and truth values.

A new atom is a file of a pack that derives from `Atom`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from functools import cached_property
from math import ulp
from pathlib import Path
from typing import Any, NamedTuple

from judge.values import answers, wire
from judge.values.answers import NO_WORDS, Bounds, Errors, Exact, Real, Target, Tolerance, Words
from judge.values.wire import Raw, Tokens, Unreadable

Number = int | float
Value = Any  # an answer that was read, or a parameter's
Leaf = Callable[[], tuple[Real, Tolerance]]  # an exact number and its tolerance
Quick = Callable[[Raw, Target], float | None]

_FEW_ULPS = 1000  # from here on they are no measure for a person
NOTHING = -1.0  # where nothing is measured in ulps
COORDINATES = ("x", "y", "z")
LONGEST = 20_000  # items of all levels, where the type sets no bound above that
_FLOAT = re.compile(r"-?[0-9]{1,400}(\.[0-9]{1,400})?(e[+-]?[0-9]{1,3})?", re.ASCII)
_LONG = 200  # of what is said of a value
_INTEGER = re.compile(r"-?(0|[1-9][0-9]{0,999})", re.ASCII)


class Place(NamedTuple):
    """Where in an answer something is: the part `at` of so many of a composite, which is at `outer`.

    Without a composite it is a step of the exact answer alone: into one of several that are right.
    """

    outer: Place | None = None
    at: int = 0
    composite: Any = None  # a Composite or an Entry, which names its parts
    of: int = 0

    def steps(self) -> tuple[int, ...]:
        """The indices that lead there in the exact answer."""
        return () if self.outer is None else (*self.outer.steps(), self.at)

    def name(self, *, short: bool = False) -> str:
        """The place in words, "y of point 2", nothing for the root; `short` leaves out an only point."""
        if self.outer is None:
            return ""
        around = self.outer.name(short=short)
        word = self.composite.word(self.at) if self.composite else ""
        if short and word == "point 1" and self.of == 1 and not around:
            word = ""
        return f"{word} of {around}" if word and around else word or around

    def prefix(self) -> str:
        """How a sentence about the whole of this place begins: "part 2 of item 3: ", nothing for the root."""
        name = self.name()
        return f"{name}: " if name else ""

    def mismatch(self, why: str) -> Mismatch:
        """Why what is here is wrong."""
        return Mismatch(self.prefix() + why, self.name())


ROOT = Place()


class Mismatch(NamedTuple):
    """Why an answer of the right form is wrong, where, and the errors of the number that decided."""

    message: str
    where: str = ""
    errors: Errors | tuple[None, None, None] = (None, None, None)


class Unfit(Exception):  # noqa: N818 - it never reaches a person but as its text
    """An exact answer that is none of its type; its text says why."""


class Type:
    """A type of answers and of parameters. Types are equal if they are written alike; they never change."""

    text = ""  # as problem.toml has it
    letters = ""  # of its texts, as problem.toml has them; empty: all that there are
    words: Words = NO_WORDS  # of the problem, on the type of its whole answer
    folder: Path | None = None  # a pack's own types, without which the text may mean nothing
    is_parameter = True  # whether simple values are known, which the search for simple cases needs
    is_plain = True  # whether a submission receives a parameter's value as it is kept here
    settled = True  # whether an example shows the right answer, and not one of many that differ widely
    keyed = False  # whether it holds a dict, which is kept as pairs in the order of their keys
    measured = False  # whether it holds real numbers, which have a tolerance
    optional = False  # whether the first token of a value may be `none`
    width: int | None = 1  # tokens on a line; None where that varies
    most = 1  # items of all levels in the longest answer, where the type bounds them
    lengths = 1  # that the longest of its lists may have, as many as are told apart
    noun = "a value"  # what is expected, "a number"
    plural = "values"  # "a list of numbers"
    one, several = "item", "items"  # what one and several of them in a list are called
    annotation = "object"  # in a stub

    def __str__(self) -> str:
        return self.text

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Type) and self._key == other._key

    def __hash__(self) -> int:
        return hash(self._key)

    @property
    def _key(self) -> tuple[str, Path | None, Words, str]:
        return self.text, self.folder, self.words, self.letters

    @property
    def items(self) -> int:
        """How many items an answer is read with, right or wrong."""
        return max(LONGEST, self.most)

    @cached_property
    def quick(self) -> Quick:
        """Accepts the usual right answer and says how far off it is in ulps; None where one must look closer.

        NOTHING where there is nothing to be off. May raise TypeError or ValueError instead of None.
        """
        return lambda _raw, _target: None


# -- atoms -------------------------------------------------------------------------------------------------


class Atom(Type):
    """Values of one piece, right if they equal the wanted one: target, exact answer and value are the same.

    A type of this kind says which values there are (`why_not`), how one arrives as JSON (`value_of`, `sent`),
    how it is written as a token (`text_of`, `value_from`), and which values are simpler (`simpler`).
    """

    samples: Sequence[Any] = ()  # a few values, the simplest first; without any, no parameter is of this type
    advice = ""  # how its tokens are written
    is_parameter = property(lambda self: bool(self.samples))

    def why_not(self, value: Any) -> str | None:
        """Why a value is none of this type, "'up' where left or right is expected"; None where it is one."""
        raise NotImplementedError

    def beyond(self, value: Any) -> str | None:
        """Why a value is beyond the type's bounds, "12, outside 0 to 9"; None where it is not."""
        return self.why_not(value)

    def simpler(self, value: Any) -> Iterable[Any]:
        """Values that say less, the search for a small failing case tries them; no numbers need be there."""
        return ()

    def simple(self, integer: Callable[[int, int], int]) -> Any:
        """A simple value; `integer(low, high)` takes all choices."""
        return self.samples[integer(0, len(self.samples) - 1)]

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
        """The value of a token, which may be the token itself; raises ValueError."""
        if wrong := self.why_not(token):
            raise ValueError(wrong)
        return token

    def aim(self, exact: Exact, tolerance: Tolerance) -> Target:
        """What answers are held against; raises Unfit."""
        if wrong := self.why_not(exact) or self.beyond(exact):
            raise Unfit(wrong)
        if isinstance(exact, str) and len(exact) > wire.LONGEST_TEXT:  # no answer of that length arrives
            raise Unfit(f"a text of {len(exact):,} characters, where {wire.LONGEST_TEXT:,} may be sent")
        return exact

    def best(self, target: Target) -> Value:
        """The value that a perfect answer has."""
        return target

    def read(self, raw: Raw, place: Place, noun: str) -> Value:
        """The value that `raw` stands for; raises Unreadable. `noun` is what the whole answer may be."""
        try:
            return self.value_of(raw)
        except ValueError:
            name = f" for {place.name()}" if place.name() else ""
            raise Unreadable(wire.fault(raw).where(f"{self.noun} is expected{name}")) from None

    def off(self, value: Value, target: Target, leaf: Leaf) -> float | None:
        """How many ulps the value is off, NOTHING where that is not measured; None where it is wrong."""
        return NOTHING if value == target else None

    def why(self, value: Value, target: Target, words: Words, place: Place) -> Mismatch:
        """Why a value that is wrong is so: it may even be none of this type."""
        why = self.why_not(value) or f"{self.shown(target)} expected, {self.shown(value)} given"
        return place.mismatch(wire.cut(why, 3 * _LONG))

    def miss(self, value: Value, target: Target, leaf: Leaf, words: Words, place: Place) -> Mismatch:
        """The same, where the exact answer may be asked for."""
        return self.why(value, target, words, place)

    def accepted(self, target: Target) -> Any:
        """What is accepted, as JSON: the least and the greatest number."""
        return list(target[:2]) if self.measured else target

    def listed(self, value: Value, *, received: bool = False) -> Any:
        """A parameter's value as JSON can hold it, or as a submission receives it."""
        return value

    def kept(self, value: Any) -> Value:
        """What a draw or a literal gives, as it is kept: a dict in it as pairs."""
        return value

    def take(self, tokens: Tokens, meant: str) -> Raw:
        """The answer that the next token holds, as JSON; raises Unreadable."""
        token = tokens.next()
        try:
            return self.sent(self.value_from(token))
        except ValueError:
            raise Unreadable(f"{wire.quoted(token)} where {meant} is expected{self.advice}") from None

    def shown(self, value: Value) -> str:
        """A value as a person would write it in Python, cut where it is long."""
        return wire.brief(value, _LONG) if isinstance(value, str) else wire.cut(repr(value), _LONG)


class NumberType(Atom):
    """Ints and reals, from `low` to `high` where they have such bounds: `int(0..9)` has both."""

    is_parameter = True
    kinds: tuple[type[int | float], ...]  # of a parameter's value

    def __init__(self, low: int | None = None, high: int | None = None) -> None:
        self.low, self.high = low, high
        if low is not None and high is not None:
            wire.in_order(low, high)
            self.text = f"{self.text}({low}..{high})"

    def why_not(self, value: Any) -> str | None:
        """Exactly an int or a float: a bool would not come back from the cache as it went in."""
        if type(value) not in self.kinds:
            return f"{value!r}, a {type(value).__name__}, where {type(self).noun} is expected"
        return None if value - value == 0 else f"{value!r}, which is not finite"

    def beyond(self, value: Any) -> str | None:
        """Outside the bounds, exactly."""
        if self.low is None and self.high is None:
            return None
        exact = wire.exactly(value) if isinstance(value, wire.Written) else value
        if (self.low is None or self.low <= exact) and (self.high is None or exact <= self.high):
            return None
        bounds = f"below {self.low}" if self.high is None else f"outside {self.low} to {self.high}"
        return f"{wire.show(value if isinstance(value, int | wire.Written) else float(value))}, {bounds}"

    def shown(self, value: Value) -> str:
        """In full, unless it is absurdly long."""
        return wire.show(value)

    def read(self, raw: Raw, place: Place, noun: str) -> Value:
        """An int of any size; where a float may be, a float, a Fraction or a Written too."""
        given, name = wire.number(raw), place.name()
        meant = name or (noun if self.measured else self.noun)
        if isinstance(given, wire.Refusal):
            raise Unreadable(given.where(f"{meant} is expected"))
        if isinstance(given, int) or float in self.kinds:
            return given
        kind, more = "float" if isinstance(given, float) else "number", " as an int" if name else ""
        raise Unreadable(f"the {kind} {wire.show(raw)} where {meant} is expected{more}")

    def value_from(self, token: str) -> Any:
        """An int as `repr` writes it, or else a float."""
        if int in self.kinds and _INTEGER.fullmatch(token):
            return int(token)
        if float in self.kinds and _FLOAT.fullmatch(token):
            return float(token)
        raise ValueError(f"no number: {token[:40]!r}")


class IntType(NumberType):
    """`int`: no bool, and no float that is whole."""

    text, noun, plural, annotation, kinds = "int", "an int", "ints", "int", (int,)

    @cached_property
    def quick(self) -> Quick:
        """Whether they are equal."""
        return lambda raw, target: NOTHING if type(raw) is int and raw == target else None

    def take(self, tokens: Tokens, meant: str) -> Raw:
        """A plain integer."""
        return tokens.integer(meant)


class RealType(NumberType):
    """`real`: an int or a float among others, held against (lo, hi, nearest)."""

    text, noun, plural, annotation, measured = "real", "a number", "numbers", "float", True
    kinds: tuple[type[int | float], ...] = (int, float)

    def aim(self, exact: Exact, tolerance: Tolerance) -> Target:
        """The least and the greatest double that is accepted, and the nearest one."""
        if type(exact) is not Real:
            raise Unfit(f"{exact!r} where a Real is expected")
        if isinstance(exact.x, float) or isinstance(exact.unit, float):  # rounded already, most likely
            raise Unfit(f"{exact!r} holds a float; write Fraction(x) where a double is the exact number")
        if wrong := self.beyond(exact.x):
            raise Unfit(wrong)
        return answers.accepted_doubles(exact, tolerance)

    def best(self, target: Bounds) -> Value:
        """The nearest double."""
        return target[2]

    @cached_property
    def quick(self) -> Quick:
        """Two comparisons, and the error."""

        def quick(raw: Raw, target: Target) -> float | None:
            lo, hi, nearest = target
            if type(raw) is not float:
                if type(raw) is not wire.Written or not lo < raw.approx < hi:
                    return None
                raw = raw.approx
            if not lo <= raw <= hi:
                return None
            return abs(raw - nearest) / ulp(nearest) if nearest else 0.0

        return quick

    def off(self, value: Value, target: Bounds, leaf: Leaf) -> float | None:
        """Its error, as its double has it; 0 where x is 0, which has no scale."""
        lo, hi, nearest = target
        if not (lo <= value <= hi if type(value) is float else answers.accepts(value, target, leaf)):
            return None
        return abs(wire.near(value) - nearest) / ulp(nearest) if nearest else 0.0

    def why(self, value: Value, target: Bounds, words: Words, place: Place) -> Mismatch:
        """How far off it is."""
        nearest = target[2]
        found = absolute, relative, ulps = answers.errors(value, nearest)
        where = place.name(short=True) or words.answer or "the answer"
        if words.negative and wire.near(value) < 0 <= nearest:
            return Mismatch(f"{where} is negative: {words.negative}", where, found)
        share = "" if relative is None else f", relative error {relative:.2g}"
        if ulps is not None and ulps < _FEW_ULPS:
            share += f" ({ulps:.3g} ulps)"
        how = answers.cut_digits(value, nearest)
        message = f"{where} is off by {absolute:.2g}{share}{how and f'; {how}'}"
        return Mismatch(message, where, found)

    def take(self, tokens: Tokens, meant: str) -> Raw:
        """A decimal."""
        return tokens.number(meant)


class DoubleType(RealType):
    """The floats of an array."""

    noun, kinds = "a float", (float,)
