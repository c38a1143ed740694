"""The atoms: ints, real numbers and words."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from functools import cached_property
from typing import Any

from judge.values.answers import Exact, Real, Tolerance, Words, accepted_doubles
from judge.values.base import (
    COORDINATES,
    NOTHING,
    Atom,
    Draws,
    Leaf,
    Mismatch,
    Number,
    Place,
    Quick,
    Target,
    Unfit,
    Value,
)
from judge.values.wire import (
    LONGEST_WORD,
    Bounds,
    Fault,
    Raw,
    Tokens,
    Unreadable,
    Written,
    accepts,
    cut_digits,
    errors,
    near,
    number,
    quoted,
    show,
    word,
)

_DECIMALS = 6  # in a doctest
_FLOAT = re.compile(r"-?[0-9]{1,400}(\.[0-9]{1,400})?(e[+-]?[0-9]{1,3})?", re.ASCII)
_INTEGER = re.compile(r"-?(0|[1-9][0-9]{0,999})", re.ASCII)


class _Numeric(Atom):
    """Numbers, which have bounds."""

    is_parameter = True

    def __init__(self, *, least: int | None = None) -> None:
        self.least = least

    def simple(self, draw: Draws, number: Callable[[bool], Number], *, positive: bool) -> Value:
        """The next simple number."""
        return number(positive or (self.least is not None and self.least >= 0))


class IntType(_Numeric):
    """`int`: no bool, and no float that is whole."""

    text, noun, plural, annotation = "int", "an int", "ints", "int"

    @cached_property
    def quick(self) -> Quick:
        """Whether they are equal."""
        return lambda raw, target: NOTHING if type(raw) is int and raw == target else None

    def why_not(self, value: Any) -> str | None:
        """Exactly an int."""
        return None if type(value) is int else f"{value!r} where an int is meant"

    def read(self, raw: Raw, place: Place, noun: str) -> Value:
        """An int of any size."""
        given = number(raw)
        name = place.name()
        if isinstance(given, Fault):
            raise Unreadable(given.where(f"{name or self.noun} is meant"))
        if not isinstance(given, int):
            kind, more = "float" if isinstance(given, float) else "number", " as an int" if name else ""
            raise Unreadable(f"the {kind} {show(raw)} where {name or self.noun} is meant{more}")
        return given

    def take(self, tokens: Tokens, meant: str) -> Raw:
        """A plain integer."""
        return tokens.integer(meant)

    def shown_target(self, target: Target) -> str:
        """In full, unless it is absurdly long."""
        return show(target)

    def asserts(self, what: str, target: Target) -> str:
        """A bool or a float may be equal to an int."""
        return f"{what} == {target} and not isinstance({what}, (bool, float))"

    def form(self, value: Any) -> str:
        """An int is a count of something."""
        return "count"

    def double(self, value: Any, *, target: bool) -> float | None:
        """The double next to it."""
        return near(value)

    def fault(self, name: str, value: Any) -> str | None:
        """Exactly an int."""
        if type(value) is float:
            return f"{name} has the float {value!r} where an int is meant"
        return _no_number(name, value)

    def value_from(self, token: str) -> Any:
        """An int as `repr` writes it."""
        if not _INTEGER.fullmatch(token):
            raise ValueError(f"no int: {token[:40]!r}")
        return int(token)

    def simple(self, draw: Draws, number: Callable[[bool], Number], *, positive: bool) -> Value:
        """The next simple number."""
        return int(super().simple(draw, number, positive=positive))


class RealType(_Numeric):
    """`real`: an int or a float among others, held against (lo, hi, nearest); `double`: floats alone."""

    text, noun, plural, annotation, measured = "real", "a number", "numbers", "float", True
    rounded = f"round({{0}}, {_DECIMALS}) + 0.0"

    def __init__(self, *, least: int | None = None, double: bool = False) -> None:
        super().__init__(least=least)
        self._double = double

    def aim(self, exact: Exact, tolerance: Tolerance) -> Target:
        """The least and the greatest double that is accepted, and the nearest one."""
        if type(exact) is not Real:
            raise Unfit(f"{exact!r} where a Real is meant")
        if isinstance(exact.x, float) or isinstance(exact.unit, float):  # rounded already, most likely
            raise Unfit(f"{exact!r} holds a float; write Fraction(x) where a double is the exact number")
        return accepted_doubles(exact, tolerance)

    @cached_property
    def quick(self) -> Quick:
        """Two comparisons, and the error."""
        ulp = math.ulp

        def quick(raw: Raw, target: Target) -> float | None:
            lo, hi, nearest = target
            if type(raw) is not float:
                if type(raw) is not Written or not lo < raw.approx < hi:
                    return None
                raw = raw.approx
            if not lo <= raw <= hi:
                return None
            return abs(raw - nearest) / ulp(nearest) if nearest else 0.0

        return quick

    def read(self, raw: Raw, place: Place, noun: str) -> Value:
        """An int, a float, a Fraction or a Written."""
        given = number(raw)
        if isinstance(given, Fault):
            is_point = place.word in COORDINATES and given.type.startswith("complex")
            remedy = "return a point as (x, y)" if is_point else ""
            raise Unreadable(given.where(f"{place.name() or noun} is meant", remedy))
        return given

    def off(self, value: Value, target: Bounds, leaf: Leaf) -> float | None:
        """Its error, as its double has it; 0 where x is 0, which has no scale."""
        lo, hi, nearest = target
        if not (lo <= value <= hi if type(value) is float else accepts(value, target, leaf)):
            return None
        return abs(near(value) - nearest) / math.ulp(nearest) if nearest else 0.0

    def why(self, value: Value, target: Bounds, words: Words, place: Place) -> Mismatch:
        """How far off it is."""
        nearest = target[2]
        found = absolute, relative, ulps = errors(value, nearest)
        where = place.name(short=True) or words.answer or "the answer"
        share = "" if relative is None else f", relative error {relative:.2g} ({ulps:.3g} ulps)"
        how = cut_digits(value, nearest)
        message = f"{place.told() or where} is off by {absolute:.2g}{share}{how and f'; {how}'}"
        return Mismatch(message, where, found)

    def take(self, tokens: Tokens, meant: str) -> Raw:
        """A decimal."""
        return tokens.number(meant)

    def token(self, target: Bounds) -> str:
        """The nearest double."""
        return repr(target[2])

    def shown_target(self, target: Bounds) -> str:
        """The nearest double."""
        return repr(target[2])

    def exact_text(self, exact: Exact) -> Any:
        """Decimal text of up to 40 digits."""
        from judge.exact import Surd

        return Surd.of(exact.x).decimal(40)

    def accepted(self, target: Bounds) -> Any:
        """The ends."""
        return list(target[:2])

    def asserts(self, what: str, target: Bounds) -> str:
        """Between the ends."""
        return f"{target[0]!r} <= {what} <= {target[1]!r}"

    def form(self, value: Any) -> str:
        """All numbers are alike."""
        return "number"

    def double(self, value: Any, *, target: bool) -> float | None:
        """The double next to it."""
        return value[2] if target else near(value)

    def fault(self, name: str, value: Any) -> str | None:
        """Exactly an int or a float: a bool would not come back from the cache as it went in."""
        if type(value) is float:
            return None if math.isfinite(value) else f"{name} has {value!r}, which is not finite"
        if self._double and type(value) is int:
            return f"{name} has the int {value!r} where a float is meant"
        return _no_number(name, value)

    def text_of(self, value: Any) -> str:
        """As `repr` writes it."""
        return repr(value)

    def value_from(self, token: str) -> Any:
        """An int, or else a float."""
        if _INTEGER.fullmatch(token) and not self._double:
            return int(token)
        if not _FLOAT.fullmatch(token):
            raise ValueError(f"no number: {token[:40]!r}")
        return float(token)

    def simple(self, draw: Draws, number: Callable[[bool], Number], *, positive: bool) -> Value:
        """The next simple number."""
        found = super().simple(draw, number, positive=positive)
        return float(found) if self._double else found

    def round(self, value: Value) -> Value:
        """To a few decimals."""
        return round(value, _DECIMALS) + 0.0


def _no_number(name: str, value: Any) -> str | None:
    if type(value) is int:
        return None
    return f"{name} has {value!r}, a {type(value).__name__}, where a number is meant"


class WordType(Atom):
    """`word(a|b|…)`: one of a few words, a str of ASCII letters, digits, hyphens and underscores."""

    annotation, plural = "str", "words"

    def __init__(self, *words: str) -> None:
        if len(words) < 2 or len(set(words)) < len(words) or "none" in words:
            raise ValueError("a word is one of two or more, all of them different and none of them none")
        if max(map(len, words)) > LONGEST_WORD:
            raise ValueError(f"a word has at most {LONGEST_WORD} characters")
        self.text, self.samples = f"word({'|'.join(words)})", words
        self.noun = f"{', '.join(words[:-1])} or {words[-1]}"

    @cached_property
    def quick(self) -> Quick:
        """Whether it is sent as that word."""
        return lambda raw, target: NOTHING if type(raw) is dict and raw == {"word": target} else None

    def why_not(self, value: Any) -> str | None:
        """One of the choice."""
        known = type(value) is str and value in self.samples
        return None if known else f"{value!r} where {self.noun} is meant"

    def value_of(self, raw: Raw) -> Any:
        """Any word: a wrong one is a wrong answer."""
        given = word(raw)
        if given is None:
            raise ValueError("no word")
        return given

    def why(self, value: Value, target: Target, words: Words, place: Place) -> Mismatch:
        """A word that is no choice at all is told as that."""
        wrong = self.why_not(value)
        if wrong:
            return Mismatch(f"{place.prefix()}{wrong}", place.name())
        return super().why(value, target, words, place)

    def sent(self, value: Any) -> Raw:
        """As a word."""
        return {"word": value}

    def shown(self, raw: Raw) -> str:
        """Between quotation marks."""
        return repr(raw) if type(raw) is str else show(raw)

    def take(self, tokens: Tokens, meant: str) -> Raw:
        """Any word of the usual length."""
        token = tokens.next()
        if len(token) > LONGEST_WORD:
            raise Unreadable(f"{quoted(token)} where {self.noun} is meant")
        return {"word": token}

    def value_from(self, token: str) -> Any:
        """One of the choice."""
        if token not in self.samples:
            raise ValueError(f"none of the words: {token[:40]!r}")
        return token
