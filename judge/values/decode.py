"""Reading the JSON form of an answer, as `judge.sandbox.encode` writes it, believing nothing.

A number comes out as an int, a float, a Fraction or a `Written` decimal; whatever else was sent, forged or
absurd, comes out as a `Fault` that says why it is no number.

    {"word": "enter"}              a str
    {"array": ["d", "00…"]}        numbers of one type: its code in Python's `array`, and their bytes
    {"tuple": [item]}              a tuple of a single item
"""

from __future__ import annotations

import re
import sys
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from msgspec import Struct

if TYPE_CHECKING:
    from array import array

MOST_DIGITS = 2000  # of a decimal: a double's full expansion has 767 significant digits
MOST_EXPONENT = 5000
MOST_HEX = 1100  # hexadecimal digits of an integer
LONGEST_WORD = 32
CODES = ("b", "h", "i", "q", "B", "H", "I", "Q", "f", "d")  # of arrays, as Python's `array` has them
ITERATORS = {
    "generator", "zip", "map", "filter", "range", "reversed", "enumerate", "list_iterator", "tuple_iterator",
    "dict_values", "dict_keys", "islice", "chain", "deque",
}  # fmt: skip
SETS = {"set", "frozenset"}
_SHOWN = 60

_DECIMAL = re.compile(r"[+-]?[0-9]+(?:\.[0-9]+)?(?:[eE]([+-]?[0-9]+))?", re.ASCII)
_COMMA = re.compile(r"[+-]?[0-9]+,[0-9]+(?:[eE][+-]?[0-9]+)?", re.ASCII)
_HEX = re.compile(r"-?[0-9a-f]+", re.ASCII)


class Fault(Struct, frozen=True):
    """Something that is not what was meant: what it is, for a person, and what to do about it.

    `type` is the name of its Python type where that is no plain one.
    """

    text: str
    remedy: str = ""
    type: str = ""

    def where(self, meant: str, remedy: str = "") -> str:
        """The sentence that says so: `meant` is what stands there otherwise, "a number is meant"."""
        advice = self.remedy or remedy
        return f"{self.text} where {meant}" + (f": {advice}" if advice else "")


class Written(Struct, frozen=True):
    """A number in decimal text of bounded length and exponent; `approx` is its correctly rounded double."""

    text: str
    approx: float

    def exact(self) -> Fraction:
        """The number itself."""
        return Fraction(self.text)


def written_off(given: Any, bounds: tuple[float, float, float, float, float]) -> float | None:
    """How far off a decimal is, in ulps, where its double shows that it is accepted; None otherwise."""
    if type(given) is not Written:
        return None
    lo, hi, nearest, residual, unit = bounds
    y = given.approx
    if not lo < y < hi:
        return None
    return abs((y - nearest) / unit - residual) if nearest else 0.0


Given = int | float | Fraction | Written
Raw = Any  # JSON of any shape


def decimal(text: str) -> Written | Fault:
    """A plain ASCII decimal, `[+-]?digits[.digits][e[+-]digits]`, or why it is none."""
    if len(text) > MOST_DIGITS:
        return Fault(f"a number of {len(text)} characters", f"write at most {MOST_DIGITS}")
    match = _DECIMAL.fullmatch(text)
    if match is None:
        return Fault(shown(text), _why_no_decimal(text))
    power = match[1]
    if power and (len(power) > 6 or abs(int(power)) > MOST_EXPONENT):
        return Fault(shown(text), f"its exponent is beyond ±{MOST_EXPONENT}")
    return Written(text, float(text))


def _why_no_decimal(text: str) -> str:
    lower = text.lower().lstrip("+-")
    if _COMMA.fullmatch(text):
        return "it has a decimal comma; write a point"
    if not text.isascii():
        return "it has a character that is not ASCII"
    if "_" in text:
        return "it has an underscore"
    if lower.startswith("0x"):
        return "it is hexadecimal"
    if lower in {"nan", "inf", "infinity"}:
        return "it is not a finite number"
    return "it is not a plain decimal number"


def number(raw: Raw) -> Given | Fault:
    """The number that `raw` stands for, or why it stands for none."""
    kind = type(raw)
    if kind is float:
        return raw if raw - raw == 0.0 else Fault(repr(raw), "it is not a finite number")
    if kind is int or kind is Written or kind is Fraction:
        return raw  # type: ignore[no-any-return]
    if kind is dict and len(raw) == 1:
        (key, value), *_ = raw.items()
        reader = {"int": _large, "fraction": _fraction, "decimal": _decimal}.get(key)
        read = reader(value) if reader else None
        if read is not None:
            return read
    return fault(raw)


def _large(value: Raw) -> int | None:
    if type(value) is str and len(value) <= MOST_HEX and _HEX.fullmatch(value):
        return int(value, 16)
    return None


def _fraction(value: Raw) -> Fraction | None:
    if type(value) is not list or len(value) != 2:
        return None
    top, bottom = _large(value[0]), _large(value[1])
    return Fraction(top, bottom) if top is not None and bottom else None


def _decimal(value: Raw) -> Written | Fault | None:
    return decimal(value) if type(value) is str else None


def word(raw: Raw) -> str | None:
    """The word that `raw` stands for, or None; at most `LONGEST_WORD` printable characters."""
    if type(raw) is dict and len(raw) == 1:
        text = raw.get("word")
        if type(text) is str and len(text) <= LONGEST_WORD and text.isprintable():
            return text
    return None


def items(raw: Raw) -> Sequence[Raw] | None:
    """The items of a list, a tuple or an array; None for anything else."""
    if type(raw) in (list, tuple):
        return raw  # type: ignore[no-any-return]
    if type(raw) is dict and len(raw) == 1:
        single = raw.get("tuple")
        return single if type(single) is list and len(single) == 1 else numbers(raw)
    return None


def numbers(raw: Raw) -> array[Any] | None:
    """The typed array that `raw` stands for, or None."""
    sent = raw.get("array") if type(raw) is dict and len(raw) == 1 else None
    if type(sent) is not list or len(sent) != 2 or type(sent[1]) is not str or sent[0] not in CODES:
        return None
    from array import array  # late: few answers are arrays

    try:
        found = array(sent[0], bytes.fromhex(sent[1]))
    except ValueError:
        return None
    if sys.byteorder == "big":
        found.byteswap()
    return found


def fault(raw: Raw) -> Fault:
    """What a wrong `raw` is, in words, and the remedy for the mistakes people make."""
    if raw is None:
        return Fault("None")
    if type(raw) in (int, float, Written):
        return Fault(show(raw))
    if type(raw) in (list, tuple):
        return Fault("a list")
    if type(raw) is dict and set(raw) == {"type", "text"}:
        name, text = raw["type"], raw["text"]
        if type(name) is str and type(text) is str:
            return _typed(_clean(name), _clean(text))
    if type(raw) is bool:
        return _typed("bool", repr(raw))
    if type(raw) is str:
        return _typed("str", repr(raw[:_SHOWN]))
    text = word(raw)
    if text is not None:
        return _typed("str", _clean(repr(text)))
    if items(raw) is not None:
        return Fault("an array" if "array" in raw else f"the tuple {show(raw)}")
    return Fault("something that is no answer")


def _typed(name: str, text: str) -> Fault:
    if text.startswith("a subclass"):
        return Fault(f"{name}, {text},", "return a plain one", name)
    if name == "float":
        return Fault(text, "it is not a finite number", name)
    return Fault(f"the {name} {text}" if text else _unnamed(name), "", name)


def _unnamed(name: str) -> str:
    """A value of which nothing but its type is known."""
    return f"a {name}" if name in (*ITERATORS, *SETS) else f"a value of type {name}"


def _clean(text: str) -> str:
    """A forged name or text, cut and with nothing in it that could move a terminal's cursor."""
    cut = text[:_SHOWN]
    return cut if cut.isprintable() else ascii(cut)[1:-1]


def shown(text: str) -> str:
    """A token between quotation marks, cut and harmless."""
    return f'"{_clean(text)}{"…" if len(text) > _SHOWN else ""}"'


def show(raw: Raw, depth: int = 3) -> str:
    """An answer as a person would write it, bounded whatever its shape."""
    kind = type(raw)
    if kind in (list, tuple):
        if depth == 0:
            return "[…]"
        parts = [show(item, depth - 1) for item in raw[:4]] + (["…"] if len(raw) > 4 else [])
        # A list of two numbers is a point, however it was written.
        point = len(raw) == 2 and not any(type(item) in (list, tuple) for item in raw)
        return f"({', '.join(parts)})" if point else f"[{', '.join(parts)}]"
    if raw is None or kind is float:
        return repr(raw)
    if kind is dict and len(raw) == 1:
        text = word(raw)
        if text is not None:
            return repr(text)
        if "tuple" in raw and items(raw) is not None:
            return f"({show(raw['tuple'][0], depth - 1)},)" if depth else "(…,)"
        found = numbers(raw)
        if found is not None:
            return show(found.tolist(), depth)
    if kind is Written:
        return _clean(raw.text)
    read = number(raw)
    if isinstance(read, Fault):
        return read.text.rstrip(",")
    if isinstance(read, Written):
        return _clean(read.text)
    if isinstance(read, int):
        return str(read) if read.bit_length() <= 256 else f"an int of {read.bit_length()} bits"
    if isinstance(read, Fraction):
        small = max(read.numerator.bit_length(), read.denominator.bit_length()) <= 128
        return (
            f"Fraction({read.numerator}, {read.denominator})" if small else f"a Fraction near {near(read)!r}"
        )
    return repr(read)


def near(value: int | float | Fraction) -> float:
    """The double next to `value`, infinite beyond the largest."""
    try:
        return float(value)
    except OverflowError:
        return float("inf") if value > 0 else float("-inf")


def collecting(type_name: str) -> str:
    """What to do about a value of that type where a list is meant, or nothing."""
    if type_name in SETS:
        return "a set has no order, and list(...) gives it none; collect a list"
    return "wrap it in list(...)" if type_name in ITERATORS else ""
