"""Numbers, words and texts out of hostile JSON and lines of text, believing nothing.

JSON is as `judge.sandbox.encode` writes it. A number comes out as an int, a float, a Fraction or a `Written`
decimal; whatever else was sent, forged or absurd, comes out as a `Refusal` that says why it is no number.

    {"word": "enter"}              a str, a word or a text
    {"array": ["d", "00…"]}        numbers of one type: its code in Python's `array`, and their bytes
    {"tuple": [item]}              a tuple of a single item
    {"dict": [[key, value], …]}    a dict, which only its own type reads
"""

from __future__ import annotations

import re
import sys
from array import array
from collections.abc import Sequence
from fractions import Fraction
from math import inf
from typing import Any

from msgspec import Struct

MOST_DIGITS = 2000  # of a decimal: a double's full expansion has 767 significant digits
MOST_EXPONENT = 5000
MOST_HEX = 1100  # hexadecimal digits of an integer
LONGEST_TEXT = 1_000_000
CODES = tuple("bhiqBHIQfd")  # of arrays, as Python's `array` has them
ITERATORS = (
    "generator zip map filter range reversed enumerate list_iterator tuple_iterator dict_values dict_keys "
    "islice chain deque"
)
SETS = {"set", "frozenset"}
_SHOWN = 60

_DECIMAL = re.compile(r"[+-]?(?=\.?[0-9])[0-9]*(?:\.[0-9]*)?(?:[eE]([+-]?[0-9]+))?", re.ASCII)
_HEX = re.compile(r"-?[0-9a-f]+", re.ASCII)
_INTEGER = re.compile(r"[+-]?[0-9]{1,400}", re.ASCII)
_FOREIGN = re.compile(r"[^\t -~]")
_TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|\S+')  # a JSON string is one, blanks and all
_NO_DECIMALS = {  # how a text begins that is none, and what to say of it
    r"[+-]?[0-9]+,[0-9]+(e[+-]?[0-9]+)?$": "it has a decimal comma; write a point",
    r".*[^\0-\x7f]": "it has a character that is not ASCII",
    r".*_": "it has an underscore",
    r"[+-]*0x": "it is hexadecimal",
    r"[+-]*(nan|inf|infinity)$": "it is not a finite number",
    r"": "it is not a plain decimal number",
}


class Unreadable(Exception):  # noqa: N818 - it never reaches a person but as its text
    """An answer of the wrong form; its text says why."""


class Refusal(Struct, frozen=True):
    """Something that is not what was meant: what it is, for a person, and what to do about it.

    `type` is the name of its Python type where that is no plain one.
    """

    text: str
    remedy: str = ""
    type: str = ""

    def where(self, meant: str, remedy: str = "") -> str:
        """The sentence that says so: `meant` is what stands there otherwise, "a number is expected"."""
        advice = self.remedy or remedy
        return f"{self.text} where {meant}" + (f": {advice}" if advice else "")


class Written(Struct, frozen=True):
    """A number in decimal text of bounded length and exponent; `approx` is its correctly rounded double."""

    text: str
    approx: float


Given = int | float | Fraction | Written
Raw = Any  # JSON of any shape


def in_order(low: int, high: int) -> None:
    """Raise ValueError for bounds that leave nothing."""
    if low > high:
        raise ValueError("low is above high")


# -- JSON --------------------------------------------------------------------------------------------------


def decimal(text: str) -> Written | Refusal:
    """A plain ASCII decimal, such as `+1`, `1.`, `.5` or `1E+05`, or why it is none."""
    if len(text) > MOST_DIGITS:
        return Refusal(f"a number of {len(text)} characters", f"write at most {MOST_DIGITS}")
    match = _DECIMAL.fullmatch(text)
    if match is None:
        why = (why for begun, why in _NO_DECIMALS.items() if re.match(begun, text, re.IGNORECASE | re.DOTALL))
        return Refusal(quoted(text), next(why))
    power = match[1]
    if power and abs(int(power)) > MOST_EXPONENT:
        return Refusal(quoted(text), f"its exponent is beyond ±{MOST_EXPONENT}")
    return Written(text, float(text))


def number(raw: Raw) -> Given | Refusal:
    """The number that `raw` stands for, or why it stands for none."""
    kind = type(raw)
    if kind is float:
        return raw if raw - raw == 0.0 else Refusal(repr(raw), "it is not a finite number")
    if kind is int or kind is Written or kind is Fraction:
        return raw  # type: ignore[no-any-return]
    if kind is dict and len(raw) == 1:
        ((key, value),) = raw.items()
        if key == "decimal" and type(value) is str:
            return decimal(value)
        if key == "int" and (whole := _large(value)) is not None:
            return whole
        if key == "fraction" and type(value) is list and len(value) == 2:
            top, bottom = map(_large, value)
            if top is not None and bottom:
                return Fraction(top, bottom)
    return fault(raw)


def _large(value: Raw) -> int | None:
    return int(value, 16) if type(value) is str and len(value) <= MOST_HEX and _HEX.fullmatch(value) else None


def word(raw: Raw) -> str | None:
    """The word or the text that `raw` stands for, or None; of any characters, at most `LONGEST_TEXT`."""
    text = raw.get("word") if type(raw) is dict and len(raw) == 1 else None
    return text if type(text) is str and len(text) <= LONGEST_TEXT else None


def items(raw: Raw) -> Sequence[Raw] | None:
    """The items of a list, a tuple or an array; None for anything else."""
    if type(raw) in (list, tuple):
        return raw  # type: ignore[no-any-return]
    if type(raw) is dict and len(raw) == 1:
        single = raw.get("tuple")
        return single if type(single) is list and len(single) == 1 else numbers(raw)
    return None


def entries(raw: Raw) -> list[list[Raw]] | None:
    """The pairs of a dict; None for anything else."""
    sent = raw.get("dict") if type(raw) is dict and len(raw) == 1 else None
    if type(sent) is not list or not all(type(each) is list and len(each) == 2 for each in sent):
        return None
    return sent


def numbers(raw: Raw) -> array[Any] | None:
    """The typed array that `raw` stands for, or None."""
    sent = raw.get("array") if type(raw) is dict and len(raw) == 1 else None
    if type(sent) is not list or len(sent) != 2 or type(sent[1]) is not str or sent[0] not in CODES:
        return None
    try:
        found = array(sent[0], bytes.fromhex(sent[1]))
    except ValueError:
        return None
    if sys.byteorder == "big":
        found.byteswap()
    return found


def fault(raw: Raw) -> Refusal:
    """What a wrong `raw` is, in words, and the remedy for the mistakes people make."""
    kind = type(raw)
    text = raw if kind is str else word(raw)
    if raw is None or kind in (int, float, Written):
        return Refusal(show(raw))
    if kind in (list, tuple):
        return Refusal("a list")
    if kind is bool:
        return _typed("bool", repr(raw))
    if entries(raw) is not None:
        return Refusal("a dict", "", "dict")
    if text is not None:
        return _typed("str", show(raw))
    if items(raw) is not None:
        return Refusal("an array" if "array" in raw else f"the tuple {show(raw)}")
    if kind is dict and set(raw) == {"type", "text"} and set(map(type, raw.values())) == {str}:
        return _typed(_clean(raw["type"]), _clean(raw["text"]))
    return Refusal("something that is not an answer")


def _typed(name: str, text: str) -> Refusal:
    if text.startswith("a text of"):  # that is too long to be sent
        return Refusal(f"{text},", "", name)
    if text.startswith("a subclass"):
        return Refusal(f"{name}, {text},", "return a plain one", name)
    if name == "float":
        return Refusal(text, "it is not a finite number", name)
    unnamed = f"a {name}" if name in (*ITERATORS.split(), *SETS) else f"a value of type {name}"
    return Refusal(f"the {name} {text}" if text else unnamed, "", name)


def _clean(text: str) -> str:
    """A forged name or text, cut and with nothing in it that could move a terminal's cursor."""
    return cut(text if text.isprintable() else ascii(text)[1:-1])


def quoted(text: str) -> str:
    """A token between quotation marks, cut and harmless."""
    return f'"{_clean(text)}"'


def brief(text: str, most: int = _SHOWN) -> str:
    """A text as Python writes it; of a long one the beginning, and its length."""
    whole = repr(text[: most + 1])
    if len(whole) <= most + len("''"):
        return whole
    return f"{text[: most * most // len(whole)]!r}… ({len(text):,} characters)"


def cut(text: str, most: int = _SHOWN) -> str:
    """A text to be shown: its end is left out where it is long."""
    return text if len(text) <= most else f"{text[:most]}…"


def show(raw: Raw, depth: int = 3) -> str:
    """An answer as a person would write it, bounded whatever its shape."""
    kind, text, found = type(raw), word(raw), items(raw)
    if found is not None:
        if depth == 0:
            return "[…]"
        parts = [show(item, depth - 1) for item in found[:4]] + ["…"] * (len(found) > 4)
        if kind is dict and "tuple" in raw:
            return f"({parts[0]},)"
        # A list of two numbers is a point, however it was written.
        point = len(found) == 2 and not any(type(item) in (list, tuple) for item in found)
        return f"({', '.join(parts)})" if point else f"[{', '.join(parts)}]"
    if (pairs := entries(raw)) is not None:
        parts = [": ".join(show(each, depth - 1) for each in pair) for pair in pairs[: 4 * (depth > 0)]]
        return f"{{{', '.join(parts + ['…'] * (len(pairs) > len(parts)))}}}"
    if text is not None or kind is str:
        return brief(raw if text is None else text)
    if raw is None or kind is float or kind is bool:
        return repr(raw)
    read = number(raw)
    if isinstance(read, Refusal):
        return read.text.rstrip(",")
    if isinstance(read, Written):
        return _clean(read.text)
    whole, bits = isinstance(read, int), max(part.bit_length() for part in read.as_integer_ratio())
    if bits <= (256 if whole else 128):
        return repr(read)
    return f"an int of {bits} bits" if whole else f"a Fraction near {near(read)!r}"


def exactly(value: Given) -> Fraction:
    """A finite number itself."""
    return Fraction(value.text if isinstance(value, Written) else value)


def near(value: Given) -> float:
    """The double next to a number, infinite beyond the largest."""
    if isinstance(value, Written):
        return value.approx
    try:
        return float(value)
    except OverflowError:
        return inf if value > 0 else -inf


def collecting(type_name: str) -> str:
    """What to do about a value of that type where a list is expected, or nothing."""
    if type_name in SETS:
        return "a set has no order, and list(...) gives it none; collect a list"
    return "wrap it in list(...)" if type_name in ITERATORS.split() else ""


# -- lines of text -----------------------------------------------------------------------------------------


def tokens(line: str) -> list[str]:
    """What a line is made of: words, numbers, JSON strings."""
    return _TOKEN.findall(line) if '"' in line else line.split()


class Tokens:
    """A line's tokens, read strictly, one after the other: `words` are those left, the next one last.

    `meant` says what the whole line holds.

    Raises Unreadable for what is not plain ASCII text.
    """

    def __init__(self, line: str, meant: str) -> None:
        line = line.removesuffix("\r")
        foreign = _FOREIGN.search(line)
        if foreign:
            name = f"{foreign[0]!r} (U+{ord(foreign[0]):04X})"
            raise Unreadable(f"{name} in the output: answers are plain ASCII text")
        self.words = tokens(line)[::-1]
        self.meant = meant
        if not self.words:
            raise Unreadable(f"an empty line where {meant} is expected")

    @property
    def ahead(self) -> str:
        """The next token, which stays; empty at the end."""
        return self.words[-1] if self.words else ""

    def next(self) -> str:
        """Take a token; raises Unreadable at the end of the line."""
        if not self.words:
            raise Unreadable(f"the line ends too early: it holds {self.meant}")
        return self.words.pop()

    def integer(self, meant: str) -> int:
        """Take an integer."""
        token = self.next()
        if not _INTEGER.fullmatch(token):
            raise Unreadable(f"{quoted(token)} where {meant} is expected: write a plain integer")
        return int(token)

    def number(self, meant: str) -> Written:
        """Take a decimal."""
        read = decimal(self.next())
        if isinstance(read, Refusal):
            raise Unreadable(f"{read.text} where {meant} is expected: {read.remedy}")
        return read
