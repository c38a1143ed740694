"""Reading what a person types as an answer."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction

NONE = "none"
_NUMBER = re.compile(r"([+-]?)(\d{1,40})(?:\.(\d{0,40}))?(?:e([+-]?\d{1,3}))?(?:/(\d{1,40}))?", re.IGNORECASE)
_LONGEST = 40  # characters of it that are quoted
NUMBER = "4, 0.5, 1e-9 or 2/3"


class MistypedError(Exception):
    """What was typed is not an answer; the message says what one looks like."""


def number(text: str) -> Fraction:
    """The number that is typed. Raises MistypedError."""
    found = _NUMBER.fullmatch(text.strip().replace("−", "-").replace(" ", ""))
    if found is None:
        raise mistyped(text, "a number", NUMBER)
    sign, whole, part, power, under = found.groups()
    value = Fraction(f"{sign}{whole}.{part or 0}") * Fraction(10) ** int(power or 0)
    if under is None:
        return value
    if not int(under):
        raise MistypedError("Nothing can be divided by 0")
    return value / int(under)


def count(text: str) -> str:
    """How many are typed, or `none`. Raises MistypedError."""
    word = text.strip().lower()
    if word == NONE:
        return NONE
    if not re.fullmatch(r"\d{1,6}", word, re.ASCII):
        raise mistyped(text, "a number", "0, 1, 2 … or none")
    return str(int(word))


def option(text: str, letters: Sequence[str]) -> str:
    """The letter that is typed. Raises MistypedError."""
    word = text.strip().lower().strip("().")
    if word not in letters:
        raise mistyped(text, "one of the options", letters_of(letters))
    return word


def letters_of(letters: Sequence[str]) -> str:
    """`a, b or c`."""
    return listed(letters, "or")


def listed(words: Sequence[str], last: str) -> str:
    """The words with commas, and the `last` word before the last of them."""
    *first, end = words
    return f"{', '.join(first)} {last} {end}" if first else end


def sequence(text: str, words: Mapping[str, str]) -> tuple[str, ...]:
    """The words that are typed, each as it is or by what it means, in any case; empty for `none`.

    Words of one letter each may be typed without blanks. Raises MistypedError.
    """
    parts = [part for part in re.split(r"[\s,;>→]+", text.strip()) if part]
    if [part.lower() for part in parts] == [NONE]:
        return ()
    known = {word.lower(): word for word in words}
    known |= {meaning.lower(): word for word, meaning in words.items() if meaning}
    if len(parts) == 1 and parts[0].lower() not in known and all(len(word) == 1 for word in words):
        parts = list(parts[0])
    found = [known.get(part.lower()) for part in parts]
    lost = next((part for part, word in zip(parts, found, strict=True) if word is None), None)
    if lost is not None or not parts:
        every = listed(list(words), "and")
        raise mistyped(lost or text, f"one of {every}", "them in their order, or none")
    return tuple(word for word in found if word is not None)


def mistyped(text: str, kind: str, remedy: str) -> MistypedError:
    """That this is not an answer, and what to type."""
    word = text.strip()
    shown = repr(word if len(word) <= _LONGEST else f"{word[:_LONGEST]}…")
    return MistypedError(f"{shown} is not {kind}. Type {remedy}")
