"""The value that an answer stands for, out of JSON of any shape or a line of text."""

from __future__ import annotations

from collections.abc import Sequence

from judge.values.answers import NO_WORDS, Words
from judge.values.atoms import ROOT, Atom, IntType, Place, Type, Value
from judge.values.letters import TextType
from judge.values.show import is_one_item, shown
from judge.values.types import (
    Composite,
    DictPart,
    DictType,
    Entries,
    ListType,
    OptionalType,
    TupleType,
    lasting,
)
from judge.values.wire import Raw, Tokens, Unreadable, collecting, fault, quoted, show


def read(type_: Type, raw: Raw, place: Place = ROOT, *, bounded: bool = True) -> Value:
    """The value that an answer stands for; raises Unreadable.

    `bounded` says whether a list may have no more items than its type says.
    """
    inner = lasting(type_)
    if raw is None and inner is not type_:
        return None
    if isinstance(inner, Atom):
        return inner.read(raw, place, type_.noun if place is ROOT else inner.noun)
    found = inner.found(raw)
    if found is None or is_one_item(inner, found):
        raise Unreadable(_no_parts(inner, raw, found, place))
    count = len(found)
    if (bounded or isinstance(inner, TupleType)) and (wrong := inner.wrong_count(count)):
        raise Unreadable(f"{place.name() or 'the answer'} has {wrong}")
    if isinstance(inner, DictType):
        return _entries(inner, found, place, bounded=bounded)
    if isinstance(inner, ListType) and isinstance(inner.item, IntType) and set(map(type, found)) <= {int}:
        return list(found)  # a million of them, perhaps
    return inner.kind(
        [
            read(part, each, Place(place, at, inner, count), bounded=bounded)
            for at, (part, each) in enumerate(inner.pairs(found))
        ]
    )


def _entries(type_: DictType, found: Sequence[Raw], place: Place, *, bounded: bool) -> Value:
    """The entries, in the order of their keys."""
    read_ones: dict[Value, Value] = {}
    for at, (sent, raw) in enumerate(found):
        key = read(type_.key, sent, Place(place, at, DictPart("a key")), bounded=bounded)
        if key in read_ones:
            raise Unreadable(f"{place.prefix()}the key {type_.key.shown(key)} is there twice")
        read_ones[key] = read(type_.value, raw, entry(type_, key, place, at), bounded=bounded)
    return Entries(sorted(read_ones.items()))


def entry(type_: DictType, key: Value, place: Place, at: int) -> Place:
    """The place of what stands at that key; `at` is where its pair is."""
    return Place(Place(place, at, DictPart(f"entry {type_.key.shown(key)}")), 1)


def _no_parts(type_: Composite, raw: Raw, found: Sequence[Raw] | None, place: Place) -> str:
    name = place.name()
    what = f"{name} is expected to be {type_.noun}" if name else f"{type_.noun} is expected"
    wrong = fault(raw)
    if not isinstance(type_, ListType):
        return wrong.where(what)
    if found is not None:
        return f"{shown(type_.item, raw)} where {what}"
    empty = "no entries are {}" if isinstance(type_, DictType) else f"no {type_.several} are []"
    none = empty if raw is None and not type_.low else ""
    return wrong.where(what, none or collecting(wrong.type))


def read_line(type_: Type, text: str) -> tuple[Raw] | str:
    """The answer that a line holds, in a tuple of one, or why it holds none."""
    try:
        line = Tokens(text, meant(type_))
        raw = line.next() if type_.width == 1 and line.words[1:] else _take(type_, line, whole=True)
        if line.words:
            raise Unreadable(f"{quoted(line.ahead)} after the answer: one line holds {line.meant}")
    except Unreadable as why:
        return str(why)
    return (raw,)


def meant(type_: Type) -> str:
    """What a line holds, in words."""
    return type_.words.meant or _hint(type_, type_.words)


def _take(type_: Type, line: Tokens, *, whole: bool = False) -> Raw:
    """The answer that the next tokens hold; raises Unreadable. `whole` says that it is all of the line."""
    inner, ahead = lasting(type_), line.ahead
    if inner is not type_ and ahead.lower() in {"none", "null"}:
        if ahead == "none":
            line.next()
            return None
        if isinstance(inner, TextType):
            return inner.take(line, line.meant)
        what = line.meant if whole and type_.width == 1 else _hint(type_)
        raise Unreadable(f"{quoted(ahead)} where {what} is expected: write none in lower case")
    if isinstance(inner, Atom):
        return inner.take(line, line.meant if whole else inner.noun)
    count = _count(inner, line, whole=whole) if isinstance(inner, ListType) else 0
    found = [_take(part, line) for part in inner.parts(count)]
    return {"dict": found} if isinstance(inner, DictType) else found


def _count(type_: ListType, line: Tokens, *, whole: bool) -> int:
    """The length of the list that follows."""
    if line.ahead.lower() == "none":
        raise Unreadable(f'"{line.ahead}" where {_hint(type_)} is expected: no {type_.several} are 0')
    count = line.integer(f"the number of {type_.several} k")
    if not type_.fits(count):
        raise Unreadable(f"k = {show(count)} where {type_.bounds()} {type_.several} are expected")
    width = type_.item.width
    if width is not None and whole and len(line.words) != count * width:
        noun = "coordinates" if type_.one == "point" else "more"
        raise Unreadable(f"k = {count} needs {count * width} {noun}, {len(line.words)} given")
    if count > len(line.words):
        raise Unreadable(f"the line ends too early: it holds {line.meant}")
    return count


def _hint(type_: Type, words: Words = NO_WORDS) -> str:
    """What a line holds, in words, as far as the type says it."""
    if isinstance(type_, OptionalType):
        return f"{_hint(type_.inner, words)} or none"
    if isinstance(type_, TupleType):
        return " ".join(type_.told) if type_.is_vector else ", ".join(map(_hint, type_.made_of))
    if isinstance(type_, DictType):
        return f"k and then k times a key and its value: {_hint(type_.key)}, {_hint(type_.value)}"
    if isinstance(type_, ListType):
        if isinstance(type_.item, TupleType) and type_.item.is_vector:
            return f"k {' '.join(f'{name}1' for name in type_.item.names)} …"
        item = _hint(type_.item)
        return f"k and then k times {item if isinstance(lasting(type_.item), Atom) else f'({item})'}"
    quotes = " (in double quotes if it is empty or has a blank)" * isinstance(type_, TextType)
    return f"{words.answer or type_.noun}{quotes}"
