"""`array(i8)`, `array(f64; most)`: a typed array of one dimension, long as it may be, sent as bytes.

As an answer it may be a numpy array, an `array.array` or a list. The target is a hexadecimal text:
of the ints' bytes, little-endian, or of the five doubles of each real (`judge.values.numbers`) in order.
As a parameter it is a tuple of numbers here, and an `array.array` in a submission.
"""

from __future__ import annotations

import sys
from array import array
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import islice
from operator import le
from typing import TYPE_CHECKING, Any

from judge.values import decode
from judge.values.atoms.real import RealType
from judge.values.lines import Tokens
from judge.values.lists import listed
from judge.values.outcome import Mismatch, Place, Unfit, Unreadable, Words
from judge.values.plain import integer_of
from judge.values.tolerance import Tolerance
from judge.values.tree import Exact
from judge.values.type import (
    MANY_LENGTHS,
    NOTHING_MEASURED,
    Draws,
    Number,
    Question,
    Quick,
    Raw,
    Target,
    Type,
)

if TYPE_CHECKING:
    from judge.values.interval import Roots

_CODES = {"i8": "b", "i16": "h", "i32": "i", "i64": "q", "u8": "B", "f64": "d"}
_DOUBLES = 5  # of a real's target
_MOST = 10_000_000  # items
_SHOWN = 20


class ArrayType(Type):
    """An array of ints, each in so many bits, or of doubles; `most` items at most."""

    plural = "arrays"
    width = None
    is_plain = False
    is_buffer = True
    lengths = MANY_LENGTHS
    depth = 1

    def __init__(self, code: str, most: str = "") -> None:
        if code not in _CODES:
            raise ValueError(f"an array holds one of {', '.join(_CODES)}")
        if most and not (most.isdecimal() and len(most) < 10 and int(most) <= _MOST):
            raise ValueError(f"an array holds at most {_MOST} items")
        self.text = f"array({code}; {most})" if most else f"array({code})"
        self._code = _CODES[code]
        self._longest = int(most) if most else _MOST
        self._real = RealType() if code == "f64" else None
        self.measured = self._real is not None
        self.annotation = "array[float]" if self._real else "array[int]"
        self.rounded_as = "list[float]" if self._real else "list[int]"
        self.noun = "an array of numbers" if self._real else "an array of ints"
        if self._real:
            self.rounded = f"[{self._real.rounded.format('item')} for item in {{0}}]"
        else:
            self.rounded = "[int(item) for item in {0}]"  # which has no type in its text

    # -- exact answers and targets -------------------------------------------------------------------

    def aimed(self, exact: Exact, tolerance: Tolerance, roots: Roots) -> Target:
        """Hexadecimal text."""
        if type(exact) not in (list, tuple, array):
            raise Unfit(f"{exact!r} where a list is meant")
        if len(exact) > self._longest:
            raise Unfit(f"{len(exact)} items where at most {self._longest} are meant")
        if self._real is None:
            try:
                return _written(array(self._code, exact))
            except (TypeError, OverflowError):
                wrong = next(each for each in exact if type(each) is not int or not self._holds(each))
                raise Unfit(f"{wrong!r} in an {self.text}") from None
        return _written(
            array("d", [end for each in exact for end in self._real.targeted(each, tolerance, roots)])
        )

    def _holds(self, value: int) -> bool:
        bits = 8 * array(self._code).itemsize
        least, beyond = (0, 1 << bits) if self._code.isupper() else (-(1 << bits - 1), 1 << bits - 1)
        return least <= value < beyond

    def _targets(self, target: Target) -> Sequence[Any]:
        """What each item is held against: an int, or five doubles."""
        if self._real is None:
            return _read(self._code, target)
        doubles = _read("d", target)
        return [doubles[at : at + _DOUBLES] for at in range(0, len(doubles), _DOUBLES)]

    # -- deciding ------------------------------------------------------------------------------------

    @cached_property
    def quick(self) -> Quick:
        """The same bytes; doubles between their ends."""
        return self._quick_ints if self._real is None else self._quick_doubles

    def _quick_ints(self, raw: Raw, target: Target) -> float | None:
        if type(raw) is not dict:
            return None
        if raw.get("array") == [self._code, target]:
            return NOTHING_MEASURED
        given = decode.numbers(raw)  # ints come in as few bytes as they fit into
        if given is None or given.typecode in "fd" or _read(self._code, target) != given:
            return None
        return NOTHING_MEASURED

    def _quick_doubles(self, raw: Raw, target: Target) -> float | None:
        given = decode.numbers(raw)
        if given is None or given.typecode != "d":
            return None
        wanted = _read("d", target)
        if len(wanted) != _DOUBLES * len(given):
            return None
        if not (all(map(le, wanted[0::5], given)) and all(map(le, given, wanted[1::5]))):
            return None
        errors = zip(given, wanted[2::5], wanted[3::5], wanted[4::5], strict=True)
        return max((abs((y - x) / ulp - rest) for y, x, rest, ulp in errors if x), default=0.0)

    def read(self, raw: Raw, question: Question, place: Place) -> Any:
        """An array, or a list of ints or numbers."""
        found = decode.items(raw)
        if found is None:
            name = place.name()
            meant = f"{name} is meant to be {self.text}" if name else f"{self.text} is meant"
            wrong = decode.fault(raw)
            raise Unreadable(wrong.where(meant, decode.collecting(wrong.type)))
        if len(found) > self._longest:
            raise Unreadable(
                f"{place.prefix()}{len(found)} items given where at most {self._longest} are meant"
            )
        if not isinstance(found, list | tuple):
            return self._typed(found, place)
        if set(map(type, found)) == {int}:  # a million of them, from a language without arrays of its own
            return list(found)
        return [self._item(each, place, at) for at, each in enumerate(found)]

    def _typed(self, found: Any, place: Place) -> Any:
        if found.typecode in "fd":
            if self._real is None:
                raise Unreadable(f"{place.prefix()}an array of floats where {self.text} is meant")
            for at, each in enumerate(found):
                if each - each != 0.0:
                    raise Unreadable(f"{each!r} where {_item(place, at).name()} is meant")
        return found

    def _item(self, raw: Raw, place: Place, at: int) -> Any:
        given = decode.number(raw)
        if isinstance(given, decode.Fault):
            raise Unreadable(given.where(f"{_item(place, at).name()} is meant"))
        if self._real is None and not isinstance(given, int):
            raise Unreadable(f"{decode.show(raw)} where {_item(place, at).name()} is meant as an int")
        return given

    def matched(self, value: Any, target: Target, question: Question, place: Place) -> float:
        """The worst of its items."""
        wanted = self._targets(target)
        if len(value) != len(wanted):
            counts = f"{len(wanted):,} {'item' if len(wanted) == 1 else 'items'} wanted, {len(value):,} given"
            raise Mismatch(place.prefix() + counts, place.name())
        if self._real is None:
            for at, (given, each) in enumerate(zip(value, wanted, strict=True)):
                if given != each:
                    spot = _item(place, at)
                    raise Mismatch(f"{spot.prefix()}{each} wanted, {decode.show(given)} given", spot.name())
            return NOTHING_MEASURED
        return max(
            (
                self._real.matched(given, each, question, _item(place, at))
                for at, (given, each) in enumerate(zip(value, wanted, strict=True))
            ),
            default=NOTHING_MEASURED,
        )

    # -- lines of text, showing ----------------------------------------------------------------------

    def take(self, tokens: Tokens) -> Raw:
        """The length, and then the items."""
        count = tokens.integer("the number of items k")
        if not 0 <= count <= min(self._longest, tokens.left):
            raise Unreadable(f"k = {str(count)[:20]} where {tokens.left} numbers follow")
        if self._real is None:
            return [tokens.integer("an int") for _ in range(count)]
        return [tokens.number("a number") for _ in range(count)]

    def hint(self, words: Words) -> str:
        """The length and the items."""
        return "k and then k numbers"

    def printed_one(self, target: Target) -> Iterator[str]:
        """The length and the items."""
        wanted = self._targets(target)
        yield str(len(wanted))
        yield from map(self._one, wanted)

    def _one(self, wanted: Any) -> str:
        return repr(wanted if self._real is None else wanted[2])

    def wanted_one(self, target: Target) -> str:
        """A list."""
        wanted = self._targets(target)
        return listed([self._one(each) for each in islice(wanted, _SHOWN + 1)], wanted)

    def shown(self, raw: Raw) -> str:
        """A list, cut where it is long."""
        found = decode.items(raw)
        if found is None:
            return super().shown(raw)
        return listed([decode.show(each) for each in islice(found, _SHOWN + 1)], found)

    def exact_text_one(self, exact: Exact) -> Any:
        """A list."""
        return list(exact) if self._real is None else [self._real.exact_text(each) for each in exact]

    def accepted_one(self, target: Target) -> Any:
        """A list of ints, or of the ends of each number."""
        wanted = self._targets(target)
        return list(wanted) if self._real is None else [list(each[:2]) for each in wanted]

    def asserts_one(self, what: str, target: Target) -> Iterator[str]:
        """The ints, or both ends of each number."""
        wanted = self._targets(target)
        if self._real is None:
            yield f"list({what}) == {list(wanted)}"
            return
        yield f"len({what}) == {len(wanted)}"
        for at, each in enumerate(wanted):
            yield from self._real.asserts(f"{what}[{at}]", each)

    def form(self, value: Any, *, target: bool = False) -> str:
        """How many items."""
        return f"array {len(self._targets(value) if target else value)}"

    def flat(self, value: Any, *, target: bool = False) -> Iterator[float]:
        """The items as doubles."""
        if target and self._real is not None:
            return (each[2] for each in self._targets(value))
        from judge.values.numbers import double

        return map(double, self._targets(value) if target else value)

    # -- values of parameters ------------------------------------------------------------------------

    def fault(self, name: str, value: Any) -> str | None:
        """A tuple of numbers that it can hold."""
        if type(value) is not tuple:
            return f"{name} must be a tuple of numbers, not a {type(value).__name__}"
        if len(value) > self._longest:
            return f"{name} has {len(value)} items where at most {self._longest} are meant"
        for each in value:
            if self._real is None:
                if type(each) is not int or not self._holds(each):
                    return f"{name} has {each!r} where {self.text} is meant"
            elif wrong := self._real.fault(name, each):
                return wrong
            elif type(each) is not float:
                return f"{name} has the int {each!r} where a float is meant"
        return None

    def outside(self, value: Any, low: Fraction | int, high: Fraction | int) -> tuple[Any, Any, Any] | None:
        """The first item that is outside."""
        return next(((each, low, high) for each in value if not low <= each <= high), None)

    def reals(self, value: Any) -> Iterator[Number]:
        """Its items, if they are doubles."""
        return iter(value if self._real is not None else ())

    def tokens(self, value: Any) -> Iterator[str]:
        """The length and the items."""
        yield str(len(value))
        yield from map(repr, value)

    def from_tokens(self, tokens: Iterator[str]) -> Any:
        """What `tokens` wrote."""
        count = integer_of(next(tokens))
        if count is None or not 0 <= count <= self._longest:
            raise ValueError("no such length")
        words = list(islice(tokens, count))
        if len(words) < count:
            raise ValueError("too few items")
        return tuple(map(int if self._real is None else float, words))

    def listed(self, value: Any) -> Any:
        """A list."""
        return list(value)

    def argument(self, value: Any) -> Any:
        """An `array.array`."""
        return array(self._code, value)

    def literal(self, value: Any) -> str:
        """An `array.array`."""
        return f"array({self._code!r}, {list(value)!r})"

    def simpler(self, value: Any) -> Iterator[Any]:
        """Fewer items."""
        size = len(value) // 2
        while size:
            for start in range(0, len(value), size):
                yield (*value[:start], *value[start + size :])
            size //= 2

    def round(self, value: Any) -> Any:
        """A list."""
        return list(value) if self._real is None else [self._real.round(each) for each in value]

    def simple(self, draw: Draws, number: Callable[[bool], Number], *, positive: bool) -> Any:
        """Up to three items."""
        kind = int if self._real is None else float
        count = draw.integer(0, min(3, self._longest))
        return tuple([kind(number(positive)) for _ in range(count)])


def _item(place: Place, at: int) -> Place:
    return Place(place, at, f"item {at + 1}")


def _written(numbers: array[Any]) -> str:
    if sys.byteorder == "big":
        numbers.byteswap()
    return numbers.tobytes().hex()


def _read(code: str, text: str) -> array[Any]:
    numbers = array(code, bytes.fromhex(text))
    if sys.byteorder == "big":
        numbers.byteswap()
    return numbers


TYPE = ArrayType
