"""What a submission answered, read from the words that a person is shown; any words whatever."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction

from judge.values.decode import Raw, Written, decimal, show

_LONGEST = 5000
_MOST = 4  # points that are drawn
_PLAIN = r"[+-]?[0-9]+(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?"
_NUMBER = rf"(?:{_PLAIN}|Fraction\([+-]?[0-9]+, [0-9]+\))"
_POINT = re.compile(rf"\(({_NUMBER}), ({_NUMBER})\)", re.ASCII)
_LINE = re.compile(rf"[0-9]+(?:[ \t]+{_PLAIN})*", re.ASCII)


@dataclass(frozen=True, slots=True)
class Given:
    """The numbers in an answer, in the caller's units: its points, or the one number it is."""

    points: tuple[tuple[Fraction, Fraction], ...] = ()
    number: Fraction | None = None


def read_given(text: str | None, *, points: bool) -> Given:
    """What `text` holds, as a function's answer is shown or as a program's line; nothing if unreadable.

    `points` says that points are meant, so that a line of numbers begins with how many there are.
    """
    text = (text or "").strip()
    if len(text) > _LONGEST:
        return Given()
    if points and _LINE.fullmatch(text):
        numbers = [_value(token) for token in text.split()[1:]]
        return Given(_pairs(list(zip(numbers[::2], numbers[1::2], strict=False))))
    pairs = [(_value(x), _value(y)) for x, y in _POINT.findall(text)]
    if pairs:
        return Given(_pairs(pairs))
    return Given(number=_value(text))


def given_words(answer: Raw) -> str:
    """An answer's JSON form in the words that `read_given` reads."""
    return show(answer)


def _pairs(
    found: list[tuple[Fraction | None, Fraction | None]],
) -> tuple[tuple[Fraction, Fraction], ...]:
    return tuple((x, y) for x, y in found if x is not None and y is not None)[:_MOST]


def _value(text: str) -> Fraction | None:
    """The number a token is, None for any other text and for one of absurd size."""
    if text.startswith("Fraction("):
        top, _, bottom = text[9:-1].partition(", ")
        if not re.fullmatch(r"[+-]?[0-9]{1,400}/[0-9]{1,400}", f"{top}/{bottom}", re.ASCII):
            return None
        return Fraction(int(top), int(bottom)) if int(bottom) else None
    read = decimal(text)
    return read.exact() if isinstance(read, Written) else None
