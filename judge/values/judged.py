"""Answers that the problem itself decides: `Judged` of the exact tree."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from judge.values.decode import Written, near
from judge.values.outcome import Mismatch, Place

if TYPE_CHECKING:
    from judge.values.type import Question

_WHOLE = re.compile(r"[+-]?\d{1,400}", re.ASCII)


def decide(value: Any, question: Question, place: Place) -> None:
    """Ask the problem about a value that was read; raises Mismatch where it does not accept it."""
    exact, _ = question.exact_at(place)
    if why := exact.why_not(plain(value), exact.group):
        raise Mismatch(f"{place.prefix()}{why}", place.name())


def first_of(target: Any) -> Any:
    """The target, of several the first, and of those that the problem itself accepts the sample."""
    while type(target) is dict and ("any" in target or "such as" in target):
        target = target["any"][0] if "any" in target else target["such as"]
    return target


def plain(value: Any) -> Any:
    """A value that was read, as Python has it: whole numbers are ints, of a decimal it is the double."""
    if isinstance(value, list | tuple):
        return type(value)([plain(each) for each in value])
    if isinstance(value, Written) and _WHOLE.fullmatch(value.text):
        return int(value.text)
    if isinstance(value, Written):
        return value.approx
    return near(value) if isinstance(value, Fraction) else value
