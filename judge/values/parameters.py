"""The values of parameters, kept as plain Python: ints, floats, texts, bools, None, tuples (for lists too).

A dict is kept as the tuple of its entries, pairs in the order of their keys.

What is asked of a value walks over its type's parts.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Iterator
from itertools import chain, repeat
from typing import Any

from judge.values.atoms import LONGEST, Atom, Number, NumberType, Type, Value
from judge.values.types import ArrayType, Composite, DictType, ListType, OptionalType, TupleType, lasting


def fault(type_: Type, name: str, value: Any) -> str | None:
    """What is wrong with the shape of a parameter's value, for a person, or None."""
    inner = lasting(type_)
    if value is None and inner is not type_:
        return None
    if wrong := inner.why_not(value):
        return f"{name} has {wrong}"
    faults = () if isinstance(inner, Atom) else (fault(part, name, each) for part, each in inner.pairs(value))
    return next(filter(None, faults), None)


def leaves(type_: Type, value: Value) -> Iterator[tuple[Atom, Value]]:
    """The atoms of a well-shaped value, each with its value."""
    inner = lasting(type_)
    if value is None:
        return
    if isinstance(inner, Atom):
        yield inner, value
    elif isinstance(inner, ListType) and isinstance(inner.item, Atom):  # a million of them, perhaps
        yield from zip(repeat(inner.item), value)
    else:
        for part, each in inner.pairs(value):
            yield from leaves(part, each)


def tokens(type_: Type, value: Value) -> Iterator[str]:
    """The value as a program reads it: numbers as `repr` writes them, a list begins with its length."""
    inner = lasting(type_)
    if value is None:
        yield "none"
    elif isinstance(inner, Atom):
        yield inner.text_of(value)
    else:
        if isinstance(inner, ListType):
            yield str(len(value))
        for part, each in inner.pairs(value):
            yield from tokens(part, each)


def from_tokens(type_: Type, words: Iterator[str]) -> Value:
    """The value that `tokens` wrote; raises ValueError or StopIteration for anything else."""
    inner = lasting(type_)
    if inner is not type_:
        first = next(words)
        return None if first == "none" else from_tokens(inner, chain((first,), words))
    if isinstance(inner, Atom):
        return inner.value_from(next(words))
    count = int(next(words)) if isinstance(inner, ListType) else 0
    if isinstance(inner, ListType) and not 0 <= count <= (LONGEST if inner.high is None else inner.high):
        raise ValueError("no such length")
    found = inner.arranged([from_tokens(part, words) for part in inner.parts(count)])
    if found is None:
        raise ValueError("a key is there twice")
    return found


def listed(type_: Type, value: Value, *, received: bool = False) -> Any:
    """The value with lists for lists and arrays, as JSON can hold it; with `received`, a dict as one."""
    inner = lasting(type_)
    if value is None or type_.is_plain:
        return value
    if isinstance(inner, Atom):
        return inner.listed(value, received=received)
    if isinstance(inner, ListType) and inner.item.is_plain:  # a million of them, perhaps
        parts = value
    else:
        parts = [listed(part, each, received=received) for part, each in inner.pairs(value)]
    return dict(parts) if received and isinstance(inner, DictType) else inner.kind(parts)


def argument(type_: Type, value: Value) -> Any:
    """The value as a submission receives it."""
    if value is not None and isinstance(lasting(type_), ArrayType):
        return array("d", value)
    return listed(type_, value, received=True)


def given(type_: Type, value: Value) -> Any:
    """The value as `solve` receives it: as it is kept, a dict as one."""
    inner = lasting(type_)
    if value is None or not type_.keyed or not isinstance(inner, Composite):
        return value
    parts = [given(part, each) for part, each in inner.pairs(value)]
    return dict(parts) if isinstance(inner, DictType) else tuple(parts)


def kept(type_: Type, value: Any) -> Value:
    """What a draw or a literal gives, as it is kept; what is of another shape is left as it is."""
    inner = lasting(type_)
    if not type_.keyed or value is None:
        return value
    if isinstance(inner, Atom):
        return inner.kept(value)
    if isinstance(inner, DictType):
        value = inner.ordered(value) if type(value) is dict else [value]  # pairs are not a dict
    if type(value) is not tuple or len(parts := inner.parts(len(value))) != len(value):
        return value
    return tuple(map(kept, parts, value))


def literal(type_: Type, value: Value) -> str:
    """The value as it is written in Python."""
    return repr(argument(type_, value))


def simpler(type_: Type, value: Value) -> Iterator[Value]:
    """Values that say less, of the same shape or a smaller one: numbers are left as they are."""
    if value is None:
        return
    if isinstance(type_, OptionalType):
        yield None
    inner = lasting(type_)
    if isinstance(inner, ListType):  # none of the items, half of them, all but one
        count = len(value)
        size = 2 * count
        while size := size // 2:
            if count - size >= inner.low:
                for start in range(0, count, size):
                    yield (*value[:start], *value[start + size :])
    if isinstance(inner, Atom):
        yield from inner.simpler(value)
    elif not isinstance(inner, ArrayType):
        for at, (part, each) in enumerate(inner.pairs(value)):
            for other in simpler(part, each):
                found = inner.arranged((*value[:at], other, *value[at + 1 :]))
                if found is not None:
                    yield found


def simple(
    type_: Type, integer: Callable[[int, int], int], number: Callable[[bool], Number], *, positive: bool
) -> Value:
    """A simple value; `positive` says that none of its numbers may be negative.

    `number(positive)` gives those, and `integer(low, high)` takes all other choices.
    """
    inner = lasting(type_)
    if inner is not type_ and not integer(0, 1):  # None as often as not
        return None
    if isinstance(inner, NumberType):
        found = number(positive or (inner.low is not None and inner.low >= 0))
        if inner.low is not None and inner.high is not None and not inner.low <= found <= inner.high:
            found = inner.low + int(found) % (inner.high - inner.low + 1)
        return found if type(found) in inner.kinds else inner.kinds[0](found)
    if isinstance(inner, Atom):
        return inner.simple(integer)
    count = 0
    if isinstance(inner, ListType):
        most = inner.low + 3
        count = integer(inner.low, most if inner.high is None else min(inner.high, most))
    elif isinstance(inner, TupleType) and inner.is_vector:  # a coordinate may always be negative
        positive = False
    parts = [simple(part, integer, number, positive=positive) for part in inner.parts(count)]
    return inner.arranged([*dict(parts).items()] if isinstance(inner, DictType) else parts)
