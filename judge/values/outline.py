"""What a wrong answer was, reduced to what tells one mistake from another: its form and its few numbers.

    count 1          an int where one is asked for
    points 2 x y …   a list of points, by their coordinates
    number t         a real number where one is asked for
    word enter       a word; `str a` for a text, `bool true`
    none             None
    type bool        a value of a wrong type
    shape 3 x …      a list of something else, by those of its items that are numbers
    text             a line of output that is no answer

Other types make forms of their own in the same manner. A run that ended without an answer has the outlines of
`judge.run.group`.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice
from operator import sub
from typing import Any

from judge.cache import digest
from judge.values.answers import Target
from judge.values.atoms import LONGEST, Atom, IntType, NumberType, Type, Value
from judge.values.check import ExactOf, decide
from judge.values.letters import TextType
from judge.values.reading import read, read_line
from judge.values.show import best
from judge.values.types import TupleType, atoms, lasting
from judge.values.wire import Raw, Refusal, Unreadable, items, near, number, word

Outline = tuple[str, tuple[float, ...]]

_CLOSE = 1e-3  # of the largest number: an error that is smaller is one of digits
UNREADABLE = "text"  # the form of a line that holds no answer
TEXT = "str"  # how the form of a text begins
_MOST = 64  # numbers that are kept
_LONGEST = 40  # characters of a foreign type's name that are kept, and of a form that is not cut


def outline(type_: Type, raw: Raw) -> Outline:
    """The outline of an answer, JSON of any shape whatever; never raises for one."""
    if raw is None:
        return ("none", ())
    try:
        return _of(type_, read(type_, raw, bounded=False))
    except Unreadable:
        return _misread(type_, raw)


def wrong_outline(type_: Type, raw: Raw, target: Target, exact: ExactOf) -> Outline | None:
    """None for a right answer, and else its outline."""
    found, value = decide(type_, raw, target, exact)
    if isinstance(found, float):
        return None
    return _of(type_, value[0]) if value and raw is not None else outline(type_, raw)


def line_outline(type_: Type, line: str) -> Outline:
    """The outline of one line of a program's output."""
    answer = read_line(type_, line)
    return (UNREADABLE, ()) if isinstance(answer, str) else outline(type_, answer[0])


def right(type_: Type, target: Target) -> Outline:
    """The outline of the right answer; of several the first."""
    return _of(type_, best(type_, target))


def _of(type_: Type, value: Value) -> Outline:
    numbers: list[float] = []
    form = _form(type_, value, numbers)
    if len(form) > 2 * _LONGEST:  # cut, but so that different ones stay different
        form = f"{form[:_LONGEST]}… {digest(form.encode(errors='replace'))[:8]}"
    return form, tuple(numbers[:_MOST])


def _form(type_: Type, value: Value, numbers: list[float]) -> str:
    """The form of a value without its numbers, which are added to the list."""
    if value is None:
        return "none"
    inner = lasting(type_)
    if isinstance(inner, NumberType):
        numbers.append(near(value))
        return "count" if isinstance(inner, IntType) else "number"
    if isinstance(inner, TextType):
        return f"{TEXT} {inner.text_of(value)}"
    if isinstance(inner, Atom):
        return f"{type(inner).__name__.removesuffix('Type').lower()} {inner.text_of(value)}"
    forms = [_form(part, each, numbers) for part, each in islice(inner.pairs(value), LONGEST)]
    if isinstance(inner, TupleType):
        return "point" if inner.is_vector else f"({', '.join(forms)})"
    plain = set(forms) <= {"point", "number", "count"}
    return " ".join([inner.several, str(len(value)), *(() if plain else forms)])


def _misread(type_: Type, raw: Raw) -> Outline:
    found = items(raw)
    if found is not None:
        return _shape(found, texts=any(atom.annotation == "str" for atom in atoms(type_)))
    given = number(raw)
    if isinstance(given, Refusal):
        return _wrong_type(raw)
    form = "number" if type_.measured else "count" if isinstance(given, int) else "type float"
    return form, (near(given),)


def _shape(found: Sequence[Raw], *, texts: bool) -> Outline:
    for each in found:
        for inner in items(each) or ():
            if texts and word(inner) is not None:  # which it may hold
                continue
            if isinstance(number(inner), Refusal) and items(inner) is None:
                return _wrong_type(inner)
    given = [number(item) for item in found[:4]]
    return f"shape {len(found)}", tuple(near(each) for each in given if not isinstance(each, Refusal))


def _wrong_type(raw: Any) -> Outline:
    name = type(raw).__name__
    if type(raw) is dict and type(raw.get("type")) is str:
        name = raw["type"][:_LONGEST]
    return f"type {'str' if word(raw) is not None else name}", ()


def _largest(numbers: Sequence[float], others: Sequence[float]) -> float:
    """The largest difference of two numbers in the same place."""
    return max(map(abs, map(sub, numbers, others)), default=0.0)


def only_digits(numbers: Sequence[float], wanted: Sequence[float]) -> bool:
    """Whether numbers differ from as many wanted ones by no more than lost digits."""
    return _largest(numbers, wanted) <= _CLOSE * max(map(abs, (*numbers, *wanted)), default=0.0)
