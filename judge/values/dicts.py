"""Dicts: `{K: V}`, whose keys are ints, words, texts or bools."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from operator import ge
from typing import Any, NamedTuple

from judge.values.atoms import Atom, Quick, Type, Value
from judge.values.types import ListType, TupleType
from judge.values.wire import Raw, cut, entries, number, word

_KEYS = {"int", "str", "bool"}  # annotations of what the keys of a dict are


class Entries(tuple[Any, ...]):
    """The entries of a dict, pairs in the order of their keys; shown as the dict."""

    __slots__ = ()

    def __repr__(self) -> str:
        return repr(dict(self))


class DictPart(NamedTuple):
    """What a part of a dict is called in messages."""

    name: str

    def word(self, at: int) -> str:
        """That name, wherever it stands."""
        return self.name


class DictType(ListType):
    """`{K: V}`, `{K: V; low..high}`: kept as the pairs of its entries, in the order of the keys."""

    kind = Entries
    plural = "dicts"
    keyed = True

    def __init__(self, key: Type, value: Type, low: int = 0, high: int | None = None) -> None:
        if not isinstance(key, Atom) or key.annotation not in _KEYS:
            raise ValueError("the keys of a dict are ints, words, texts or bools")
        super().__init__(TupleType((key, value)), low, high)
        self.key, self.value, self.keyed = key, value, True
        self.text = f"{{{key.text}: {value.text}{self._bounds}}}"
        self.one, self.several = "item", "items"  # it is an item of a list itself
        self.noun = f"a dict of {key.plural} to {value.plural}"
        self.annotation = f"dict[{key.annotation}, {value.annotation}]"

    def found(self, raw: Raw) -> Sequence[Raw] | None:
        """Its pairs, in the order of the keys where these have one; a list of pairs is no dict."""
        sent = raw if type(raw) is Entries else entries(raw)
        if sent is None:
            return None
        try:
            return sorted(sent, key=_order)
        except TypeError:  # keys of several types
            return sent

    def ordered(self, value: Any) -> Any:
        """The pairs of a dict whose keys are of their type; anything else as it is."""
        if type(value) is not dict or any(map(self.key.why_not, value)):
            return value
        return tuple(sorted(value.items(), key=_first))

    def wrong_count(self, count: int) -> str | None:
        """As many entries as the bounds let pass."""
        entries_ = "1 entry" if count == 1 else f"{count} entries"
        return None if self.fits(count) else f"{entries_} where {self.bounds()} are expected"

    def arranged(self, parts: Sequence[Value]) -> tuple[Value, ...] | None:
        """In the order of the keys, none of which is there twice."""
        return tuple(sorted(parts, key=_first)) if len(dict(parts)) == len(parts) else None

    def why_not(self, value: Any) -> str | None:
        """Why it is not kept as a dict is: the message is of a dict, which it was."""
        if type(value) is not tuple:
            keys = filter(None, map(self.key.why_not, value if type(value) is dict else ()))
            return next((f"a key {why}" for why in keys), f"{cut(repr(value))} where {self.noun} is expected")
        keys_of: list[Any] = [each[0] if type(each) is tuple and len(each) == 2 else None for each in value]
        if any(map(self.key.why_not, keys_of)) or any(map(ge, keys_of, keys_of[1:])):
            return f"{cut(repr(value))} where {self.noun} is expected"
        return self.wrong_count(len(value))

    @cached_property
    def quick(self) -> Quick:
        """All entries, one after the other."""
        pairs = super().quick
        return lambda raw, target: pairs(raw, target) if type(raw) is dict else None


def _first(pair: Sequence[Any]) -> Any:
    return pair[0]


def _order(pair: Sequence[Raw]) -> Any:
    """What a key is sorted by, as it was sent."""
    text, key = word(pair[0]), pair[0]
    return text if text is not None else key if type(key) in (bool, str) else number(key)
