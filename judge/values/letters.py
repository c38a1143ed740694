"""Words, texts and truth values: `word(a|b|…)`, `text(low..high)` and `bool`.

A text holds line feeds and the characters from a space to a tilde, which all languages count alike. As a
token it is written as it is where that is one word, and as a JSON string where it is not.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from functools import cached_property
from typing import Any

from judge.values import wire
from judge.values.answers import Target, Words
from judge.values.atoms import NOTHING, Atom, Mismatch, Place, Quick, Type
from judge.values.types import atoms
from judge.values.wire import Raw, Tokens, Unreadable

USUAL = " -~"  # letters of a parameter where problem.toml names none
_ALL = "\n" + "".join(map(chr, range(32, 127)))
_FOREIGN = re.compile(r"[^\n -~]")
_BARE = re.compile(r'(?!")(?!none\Z)[!-~]+')
_WHOLE = 60  # characters of a text that is shown whole, and of the part that is
_PART = 20
_SIMPLE = 4  # characters that a simple text has beyond its least
_PIECE = 3  # of a text, which is left out wherever it stands


class StrType(Atom):
    """Words and texts: any other one is a wrong answer."""

    annotation = "str"

    @cached_property
    def quick(self) -> Quick:
        """Whether it is sent as that text."""
        return lambda raw, target: NOTHING if type(raw) is dict and raw == {"word": target} else None

    def value_of(self, raw: Raw) -> Any:
        """Any text."""
        if (given := wire.word(raw)) is None:
            raise ValueError("no text")
        return given

    def sent(self, value: Any) -> Raw:
        """As `judge.sandbox.encode` writes a str."""
        return {"word": value}


class WordType(StrType):
    """`word(a|b|…)`: one of a few words, a str of ASCII letters, digits, hyphens and underscores."""

    plural = "words"

    def __init__(self, *words: str) -> None:
        if len(words) < 2 or len(set(words)) < len(words) or "none" in words:
            raise ValueError("a word is one of two or more, all of them different and none of them none")
        self.text, self.samples = f"word({'|'.join(words)})", words
        self.noun = f"{', '.join(words[:-1])} or {words[-1]}"

    def why_not(self, value: Any) -> str | None:
        """One of the choice."""
        known = type(value) is str and value in self.samples
        return None if known else f"{value!r} where {self.noun} is expected"

    def take(self, tokens: Tokens, meant: str) -> Raw:
        """Any word."""
        return self.sent(tokens.next())


class TextType(StrType):
    """`text(low..high)`: so many characters, of its `letters` where the parameter has such."""

    noun, plural, is_parameter = "a text", "texts", True

    def __init__(self, low: int = 0, high: int = 1000) -> None:
        wire.in_order(low, high)
        if low < 0:
            raise ValueError("no text has fewer than 0 characters")
        if high > wire.LONGEST_TEXT:
            raise ValueError(f"a text has at most {wire.LONGEST_TEXT:,} characters")
        self.low, self.high = low, high
        self.text = f"text({low})" if low == high else f"text({low}..{high})"

    @cached_property
    def signs(self) -> str:
        """Its letters one by one, the simplest first."""
        return "".join(sorted(expanded(self.letters) if self.letters else _ALL, key=rank))

    def why_not(self, value: Any) -> str | None:
        """A str of as many characters as the bounds let pass."""
        if type(value) is not str:
            return f"{wire.cut(repr(value))} where {self.noun} is expected"
        if self.low <= len(value) <= self.high:
            return None
        bounds = f"{self.low:,}" if self.low == self.high else f"{self.low:,} to {self.high:,}"
        return f"a text of {len(value):,} characters where {bounds} are expected"

    def beyond(self, value: Any) -> str | None:
        """The same, and other characters than its letters."""
        if wrong := self.why_not(value):
            return wrong
        if self.letters:
            known = frozenset(self.signs)
            at = next((at for at, each in enumerate(value) if each not in known), -1)
            return None if at < 0 else f"{value[at]!a}, none of its letters {self.letters!r}"
        found = _FOREIGN.search(value)
        if found is None:
            return None
        return f"{found[0]!a} at character {found.start() + 1}: only ASCII letters and signs"

    def simpler(self, value: Any) -> Iterator[str]:
        """Shorter ones, then ones of simpler letters: a letter wherever it stands, or in one place."""
        count = len(value)
        for size, step in _pieces(count):
            if count - size >= self.low:
                for start in range(0, count - (size - 1) * (step == 1), step):
                    yield value[:start] + value[start + size :]
        for letter in sorted(set(value), key=rank, reverse=True):
            for other in self._simpler_letters(letter):
                yield value.replace(letter, other)
        for at, letter in enumerate(value):
            for other in self._simpler_letters(letter):
                yield value[:at] + other + value[at + 1 :]

    def _simpler_letters(self, letter: str) -> str:
        """The simplest ones, and the next simpler."""
        at = self.signs.find(letter)
        return "".join(dict.fromkeys((*self.signs[: min(at, _PIECE)], *self.signs[max(at - 1, 0) : at])))

    def simple(self, integer: Callable[[int, int], int]) -> Any:
        """A short text of three letters, two of them perhaps the simplest."""
        pool = [self.signs[integer(0, len(self.signs) - 1)] for _ in range(3)]
        pool[:2] = self.signs[:2] if integer(0, 1) else pool[:2]
        length = integer(self.low, min(self.high, self.low + _SIMPLE))
        return "".join([pool[integer(0, len(pool) - 1)] for _ in range(length)])

    def text_of(self, value: Any) -> str:
        """Itself where it is a word, else a JSON string."""
        return value if _BARE.fullmatch(value) else json.dumps(value)

    def value_from(self, token: str) -> Any:
        """A word stands for itself; what begins with a quotation mark is a JSON string."""
        if not token.startswith('"'):
            return token
        found = json.loads(token)
        if type(found) is not str:
            raise ValueError("no text")
        return found

    def take(self, tokens: Tokens, meant: str) -> Raw:
        """Any text."""
        token = tokens.next()
        if len(token) > wire.LONGEST_TEXT:
            raise Unreadable(f"a text of {len(token):,} characters, more than {wire.LONGEST_TEXT:,}")
        try:
            return self.sent(self.value_from(token))
        except ValueError:
            what = f"{wire.brief(token)} where {meant} is expected"
            raise Unreadable(f"{what}: what begins with a quotation mark is a JSON string") from None

    def why(self, value: Any, target: Target, words: Words, place: Place) -> Mismatch:
        """Its form, or where it differs."""
        why = self.beyond(value)
        if why is None and max(len(value), len(target)) <= _WHOLE:
            why = f"{target!r} expected, {value!r} given"
        elif why is None:
            pairs = enumerate(zip(value, target, strict=False))
            at = next((at for at, (one, other) in pairs if one != other), min(len(value), len(target)))
            why = f"at character {at + 1:,}: {_part(target, at)} expected, {_part(value, at)} given"
        return place.mismatch(why)

    def shown(self, value: Any) -> str:
        """As Python writes it, cut where it is long."""
        return wire.brief(value)


class BoolType(Atom):
    """`bool`: True or False; 1 is not a bool."""

    text, noun, plural, annotation, samples = "bool", "a bool", "bools", "bool", (False, True)
    advice = ": write true or false"

    @cached_property
    def quick(self) -> Quick:
        """Whether they are the same."""
        return lambda raw, target: NOTHING if raw is target and type(raw) is bool else None

    def why_not(self, value: Any) -> str | None:
        """One of the two."""
        return None if type(value) is bool else f"{wire.cut(repr(value))} where {self.noun} is expected"

    def simpler(self, value: Any) -> tuple[bool, ...]:
        """False."""
        return (False,) if value else ()

    def value_of(self, raw: Raw) -> Any:
        """A bool alone."""
        if type(raw) is not bool:
            raise ValueError("no bool")
        return raw

    def text_of(self, value: Any) -> str:
        """As JSON has it."""
        return "true" if value else "false"

    def value_from(self, token: str) -> Any:
        """In small letters."""
        if token not in ("true", "false"):
            raise ValueError("no bool")
        return token == "true"


def rank(letter: str) -> int:
    """How simple a letter is: a is the simplest, then b; other signs come after z, as ASCII orders them."""
    return ord(letter) - ord("a") if "a" <= letter <= "z" else 26 + ord(letter)


def expanded(letters: str) -> str:
    """The letters that are meant: `x-y` is a range, and a hyphen at an end is itself. Raises ValueError."""
    found = ""
    for part in re.findall(r".-.|.", letters, re.DOTALL):
        first, last = part[0], part[-1]
        if first > last:
            raise ValueError(f"{first}-{last} is not a range: {first!r} comes after {last!r}")
        if foreign := _FOREIGN.search(first + last):
            raise ValueError(f"{foreign[0]!a} is no ASCII letter or sign")
        found += "".join(map(chr, range(ord(first), ord(last) + 1)))
    return "".join(dict.fromkeys(found))


def texts_of(type_: Type) -> list[TextType]:
    """The texts in a type."""
    return [each for each in atoms(type_) if isinstance(each, TextType)]


def _pieces(count: int) -> Iterator[tuple[int, int]]:
    """The sizes of what may be dropped of a text, each with the distance of two places where it is tried."""
    size = count
    while size > _PIECE:
        yield size, size
        size //= 2
    yield from ((size, 1) for size in range(min(_PIECE, count), 0, -1))


def _part(text: str, at: int) -> str:
    """What stands there."""
    if at >= len(text):
        return "its end"
    return f"{text[at : at + _PART]!r}{'…' * (len(text) > at + _PART)}"
