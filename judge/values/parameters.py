"""The values of parameters, kept as plain Python: ints, floats, words, None, and tuples of those (lists too).

What is asked of a value walks over its type's parts.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import chain, repeat
from typing import Any, Protocol

from judge.values.atoms import LONGEST, Atom, Number, NumberType, Type, Value
from judge.values.types import ArrayType, Composite, ListType, OptionalType, TupleType, lasting


class Draws(Protocol):
    """Where the search for simple cases takes its choices from; `judge.data.draw.Draw` is one."""

    def integer(self, low: int, high: int) -> int:
        """An int from `low` to `high`."""
        ...


def parts_of(type_: Type, value: Value) -> Iterator[tuple[Type, Value]]:
    """The parts of a well-shaped value with their types; an atom and None have none."""
    inner = lasting(type_)
    if value is not None and isinstance(inner, Composite):
        yield from zip(inner.parts(len(value)), value, strict=True)


def fault(type_: Type, name: str, value: Any) -> str | None:
    """What is wrong with the shape of a parameter's value, for a person, or None."""
    if isinstance(type_, OptionalType):
        return None if value is None else fault(type_.inner, name, value)
    if isinstance(type_, Atom):
        return type_.fault(name, value)
    if isinstance(type_, TupleType):
        if type(value) is not tuple or len(value) != len(type_.made_of):
            meant = f"a tuple {type_.text}"
            if all(isinstance(part, NumberType) for part in type_.made_of):
                meant = "a pair of numbers" if len(type_.made_of) == 2 else f"{len(type_.made_of)} numbers"
            return f"{name} must be {meant}, not {value!r}"
    elif isinstance(type_, ListType):
        if type(value) is not tuple:
            return f"{name} must be a tuple of {type_.several}, not {value!r}"
        if len(value) < type_.low or (type_.high is not None and len(value) > type_.high):
            return f"{name} has {len(value)} {type_.several} where {type_.bounds()} are meant"
    return next((wrong for part, each in parts_of(type_, value) if (wrong := fault(part, name, each))), None)


def leaves(type_: Type, value: Value) -> Iterator[tuple[Type, Value]]:
    """The atoms of a well-shaped value, each with its value."""
    type_ = lasting(type_)
    if value is None:
        return
    if isinstance(type_, Atom):
        yield type_, value
    elif isinstance(type_, ListType) and isinstance(type_.item, Atom):  # a million of them, perhaps
        yield from zip(repeat(type_.item), value, strict=False)
    else:
        for part, each in parts_of(type_, value):
            yield from leaves(part, each)


def outside(
    type_: Type, value: Value, low: Fraction | int, high: Fraction | int
) -> tuple[Any, Any, Any] | None:
    """The first number of a well-shaped value beyond the bounds, with these; None if there is none."""
    for atom, each in leaves(type_, value):
        if isinstance(atom, NumberType):
            least = low if atom.least is None else max(low, atom.least)
            if not least <= each <= high:
                return each, least, high
    return None


def reals(type_: Type, value: Value) -> Iterator[Number]:
    """The numbers of a well-shaped value that are of the type `real`."""
    return (each for atom, each in leaves(type_, value) if atom.measured)


def tokens(type_: Type, value: Value) -> Iterator[str]:
    """The value as a program reads it: numbers as `repr` writes them, a list begins with its length."""
    inner = lasting(type_)
    if value is None:
        yield "none"
    elif isinstance(inner, Atom):
        yield inner.text_of(value)
    elif isinstance(inner, ListType):
        yield str(len(value))
    for part, each in parts_of(inner, value):
        yield from tokens(part, each)


def from_tokens(type_: Type, words: Iterator[str]) -> Value:
    """The value that `tokens` wrote; raises ValueError or StopIteration for anything else."""
    if isinstance(type_, OptionalType):
        first = next(words)
        return None if first == "none" else from_tokens(type_.inner, chain((first,), words))
    if isinstance(type_, Atom):
        return type_.value_from(next(words))
    assert isinstance(type_, Composite)
    count = int(next(words)) if isinstance(type_, ListType) else 0
    if isinstance(type_, ListType) and not 0 <= count <= (LONGEST if type_.high is None else type_.high):
        raise ValueError("no such length")
    return tuple([from_tokens(part, words) for part in type_.parts(count)])


def listed(type_: Type, value: Value) -> Any:
    """The value with lists for lists and arrays, as JSON can hold it."""
    inner = lasting(type_)
    if type_.is_plain or value is None or not isinstance(inner, Composite):
        return value
    if isinstance(inner, ListType) and inner.item.is_plain:
        return list(value)
    return inner.kind([listed(part, each) for part, each in parts_of(inner, value)])


def argument(type_: Type, value: Value) -> Any:
    """The value as a submission receives it."""
    if value is not None and isinstance(lasting(type_), ArrayType):
        return array("d", value)
    return listed(type_, value)


def literal(type_: Type, value: Value) -> str:
    """The value as it is written in Python."""
    is_array = value is not None and isinstance(lasting(type_), ArrayType)
    return f"array('d', {list(value)!r})" if is_array else repr(listed(type_, value))


def simpler(type_: Type, value: Value) -> Iterator[Value]:
    """Values of the same shape or a smaller one that say less: numbers are left as they are."""
    if value is None:
        return
    if isinstance(type_, OptionalType):
        yield None
    inner = lasting(type_)
    if isinstance(inner, ListType):  # half of the items, all but one
        count = size = len(value)
        while size := size // 2:
            if count - size >= inner.low:
                for start in range(0, count, size):
                    yield (*value[:start], *value[start + size :])
    if not isinstance(inner, ArrayType):
        for at, (part, each) in enumerate(parts_of(inner, value)):
            for other in simpler(part, each):
                yield (*value[:at], other, *value[at + 1 :])


def simple(type_: Type, draw: Draws, number: Callable[[bool], Number], *, positive: bool) -> Value:
    """A simple value: `number(positive)` gives its numbers, `positive` says that none may be negative."""
    if isinstance(type_, OptionalType):  # None as often as not
        return simple(type_.inner, draw, number, positive=positive) if draw.integer(0, 1) else None
    if isinstance(type_, NumberType):
        found = number(positive or (type_.least is not None and type_.least >= 0))
        return found if type(found) in type_.kinds else type_.kinds[0](found)
    if isinstance(type_, Atom):
        return type_.samples[draw.integer(0, len(type_.samples) - 1)]
    assert isinstance(type_, Composite)
    count = 0
    if isinstance(type_, ListType):
        high = type_.low + 3 if type_.high is None else min(type_.high, type_.low + 3)
        count = draw.integer(type_.low, high)
    elif isinstance(type_, TupleType) and type_.is_vector:  # a coordinate may always be negative
        positive = False
    return tuple([simple(part, draw, number, positive=positive) for part in type_.parts(count)])
