"""What a wrong answer was, reduced to what tells one mistake from another: its form and its few numbers.

    count 1          an int where one is asked for
    points 2 x y …   a list of points, by their coordinates
    number t         a real number where one is asked for
    none             None
    type bool        a value of a wrong type
    shape 3 x …      a list of something else, by those of its items that are numbers
    text             a line of output that is no answer

Other types make forms of their own in the same manner. A run that ended without an answer has the outlines of
`judge.run.group`.
"""

from __future__ import annotations

from typing import Any

from judge.digest import digest_of
from judge.values import decode
from judge.values.decode import Fault, number
from judge.values.likeness import Outline
from judge.values.numbers import double
from judge.values.outcome import NO_WORDS, ROOT, Unreadable
from judge.values.type import Question, Type

_MOST = 64  # numbers that are kept
_LONGEST = 40  # characters of a foreign type's name that are kept, and of a form that is not cut


def _never() -> Any:
    raise AssertionError("reading an answer asks for no exact one")


_UNASKED = Question(_never, NO_WORDS, optional=False, bounded=False)


def outline(type_: Type, raw: Any) -> Outline:
    """The outline of an answer, JSON of any shape whatever; never raises for one."""
    if raw is None:
        return ("none", ())
    try:
        value = type_.read(raw, _UNASKED, ROOT)
    except Unreadable:
        return _misread(type_, raw)
    return of_value(type_, value)


def of_value(type_: Type, value: Any) -> Outline:
    """The outline of an answer that was read and is not None."""
    return short(type_.form(value)), tuple(_first(type_.flat(value)))


def right(type_: Type, target: Any) -> Outline:
    """The outline of the right answer."""
    return short(type_.form(target, target=True)), tuple(_first(type_.flat(target, target=True)))


def short(form: str) -> str:
    """A form, cut where it is long, but so that different ones stay different."""
    if len(form) <= 2 * _LONGEST:
        return form
    return f"{form[:_LONGEST]}… {digest_of(form.encode(errors='replace'))[:8]}"


def _first(numbers: Any) -> list[float]:
    from itertools import islice

    return list(islice(numbers, _MOST))


def _misread(type_: Type, raw: Any) -> Outline:
    found = decode.items(raw)
    if found is not None:
        return _shape(found)
    given = number(raw)
    if isinstance(given, Fault):
        return _wrong_type(raw)
    if type_.measured:
        return ("number", (double(given),))
    return ("count" if isinstance(given, int) else "type float", (double(given),))


def _shape(items: Any) -> Outline:
    for each in items:
        for inner in decode.items(each) or ():
            if isinstance(number(inner), Fault) and decode.items(inner) is None:
                return _wrong_type(inner)
    given = [number(item) for item in items[:4]]
    return (f"shape {len(items)}", tuple(double(each) for each in given if not isinstance(each, Fault)))


def _wrong_type(raw: Any) -> Outline:
    if type(raw) is dict and type(raw.get("type")) is str:
        return (f"type {raw['type'][:_LONGEST]}", ())
    if decode.word(raw) is not None:
        return ("type str", ())
    return (f"type {type(raw).__name__}", ())
