"""Types made of others: tuples, lists, dicts, and what may be None."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import repeat
from operator import ge
from typing import Any, NamedTuple, cast

from judge.values.answers import Target
from judge.values.atoms import COORDINATES, LONGEST, NOTHING, Atom, DoubleType, Quick, Type, Value
from judge.values.wire import Raw, cut, entries, items, number, word

MANY_LENGTHS = 1000  # of a list without a bound
_Kind = type[tuple[Any, ...]] | type[list[Any]]


class CompositeType(Type):
    """A type that is made of others."""

    def _made(self, *parts: Type) -> None:
        if any(isinstance(part, ArrayType) for part in parts) and not self.optional:
            raise ValueError("an array is a whole parameter")
        self.measured = any(part.measured for part in parts)
        self.keyed = any(part.keyed for part in parts)
        self.lengths = max(part.lengths for part in parts)
        for name in ("is_parameter", "is_plain", "settled"):
            setattr(self, name, all(getattr(part, name) for part in parts))


class OptionalType(CompositeType):
    """`T?`: None, or what `inner` says."""

    optional = True

    def __init__(self, inner: Type) -> None:
        if inner.optional:
            raise ValueError("as text it does not say whether all of it is none or only its first part")
        self._made(inner)
        self.inner = inner
        self.text, self.noun = f"{inner.text}?", f"{inner.noun} or None"
        self.annotation = f"{inner.annotation} | None"
        self.width = 1 if inner.width == 1 else None
        self.most, self.plural, self.one, self.several = inner.most, inner.plural, inner.one, inner.several

    @cached_property
    def quick(self) -> Quick:
        """Whether both are None, or the inner answer."""
        inner = self.inner.quick

        def quick(raw: Raw, target: Target) -> float | None:
            if raw is None or target is None:
                return NOTHING if raw is target else None
            return inner(raw, target)

        return quick


class Composite(CompositeType):
    """A type of several parts: those of a tuple are `made_of` one type each, those of a list all of the one.

    How many parts a value has is asked of `wrong_count`.
    """

    kind: _Kind  # of an answer that was read; Entries of a dict
    made_of: tuple[Type, ...]

    def parts(self, count: int) -> Sequence[Type]:
        """The types of the parts of a value that has so many."""
        return self.made_of if self.kind is tuple else self.made_of * count

    def pairs(self, values: Sequence[Value]) -> Iterator[tuple[Type, Value]]:
        """The parts of a value, or of what stands for them, each after its type."""
        return zip(self.parts(len(values)), values, strict=True)

    def word(self, at: int) -> str:
        """What the part `at` is called."""
        return f"{self.one} {at + 1}"

    def found(self, raw: Raw) -> Sequence[Raw] | None:
        """The parts of what was sent or read; None where it has none."""
        return items(raw)

    def arranged(self, parts: Sequence[Value]) -> tuple[Value, ...] | None:
        """A value of these parts; None where there is none."""
        return tuple(parts)

    def wrong_count(self, count: int) -> str | None:
        """Why a value cannot have so many parts: "3 points where 0 to 2 are expected"."""
        raise NotImplementedError

    def why_not(self, value: Any) -> str | None:
        """Why a value is no tuple of so many parts, which are not looked at."""
        if type(value) is not tuple:
            return f"{value!r} where a tuple is expected"
        return self.wrong_count(len(value))

    @cached_property
    def quick(self) -> Quick:
        """All parts, one after the other; of several right answers to a part the first that accepts it."""
        each = [part.quick for part in self.made_of]
        quicks = each if self.kind is tuple else repeat(each[0])

        def quick(raw: Raw, target: Target) -> float | None:
            if type(raw) is dict:  # many numbers, sent as bytes; a dict; or what has no parts at all
                found = self.found(raw)
                raw = None if found is None else list(found)
            if type(raw) is not list or type(target) is dict or len(raw) != len(target):
                return None
            worst = NOTHING
            for part, given, wanted in zip(quicks, raw, target):  # noqa: B905  # the lengths are equal
                if type(wanted) is dict:
                    ways = (part(given, one) for one in wanted.get("any", ()))
                    off = next((one for one in ways if one is not None), None)
                else:
                    off = part(given, wanted)
                if off is None:
                    return None
                if off > worst:
                    worst = off
            return worst

        return quick


class TupleType(Composite):
    """`(T, T, …)`: `names` are those of the parts in messages, `alias` is the stub's name for the type.

    A vector's parts are x, y and z.
    """

    kind = tuple
    plural = "tuples"

    def __init__(self, parts: Sequence[Type], names: Sequence[str] = (), alias: str = "") -> None:
        if len(parts) < 2:
            raise ValueError("a tuple has two parts or more")
        self._made(*parts)
        self.made_of = tuple(parts)
        self.names = tuple(names) or tuple(f"part {place}" for place in range(1, len(parts) + 1))
        self.told = self.names  # in messages; other languages keep the names
        self.is_vector = self.names == COORDINATES[: len(parts)]
        self.text = f"({', '.join(part.text for part in parts)})"
        self.optional = parts[0].optional
        widths = [part.width for part in parts]
        self.width = None if None in widths else sum(filter(None, widths))
        self.most = sum(part.most + isinstance(lasting(part), Composite) for part in parts)
        self.spelled = f"tuple[{', '.join(part.annotation for part in parts)}]"
        self.alias, self.annotation = alias, alias or self.spelled
        self.noun = f"a {self.spelled}"  # as the file to begin with spells it
        if self.is_vector:
            self.noun, self.plural = f"({', '.join(self.names)})", "points"
            self.one, self.several = "point", "points"
            for part in parts:  # which are made for it
                part.noun = "a coordinate"

    def word(self, at: int) -> str:
        """Its name."""
        return self.told[at]

    def wrong_count(self, count: int) -> str | None:
        """As many as there are."""
        if count == len(self.made_of):
            return None
        what = "coordinate" if self.is_vector else "part"
        return f"{count} {what}{'' if count == 1 else 's'} where {self.noun} is expected"


class ListType(Composite):
    """`[T]`, `[T; n]`, `[T; low..high]`: so many items; `high` is None where there is no bound."""

    kind: _Kind = list
    width = None
    plural = "lists"

    def __init__(self, item: Type, low: int = 0, high: int | None = None) -> None:
        if high is not None and not low <= high:
            raise ValueError("the bounds leave no length: low is above high")
        self._made(item)
        self.is_plain = False
        self.made_of, self.item, self.low, self.high = (item,), item, low, high
        self._bounds = "" if high is None and not low else f"; {low}" if low == high else f"; {low}..{high}"
        self.text = f"[{item.text}{self._bounds}]"
        each = item.most + isinstance(lasting(item), Composite)
        self.most = LONGEST if high is None else high * each
        self.lengths = max(item.lengths, MANY_LENGTHS if high is None else high - low + 1)
        self.one, self.several = item.one, item.several
        self.noun, self.annotation = f"a list of {item.plural}", f"list[{item.annotation}]"

    def fits(self, count: int) -> bool:
        """Whether there may be so many items."""
        return self.low <= count and (self.high is None or count <= self.high)

    def bounds(self) -> str:
        """How many items there may be, in words."""
        if self.high is None:
            return f"{self.low} or more"
        return str(self.low) if self.low == self.high else f"{self.low} to {self.high}"

    def wrong_count(self, count: int) -> str | None:
        """As many as the bounds let pass."""
        if self.fits(count):
            return None
        return f"{count} {self.one if count == 1 else self.several} where {self.bounds()} are expected"


class ArrayType(ListType):
    """`array(f64; most)`: a parameter's doubles, which a submission receives as an `array.array`."""

    def __init__(self, code: str, most: str = "") -> None:
        if code != "f64":
            raise ValueError("an array holds f64")
        if most and not (most.isdecimal() and len(most) < 10):
            raise ValueError(f"{most} is not a length of an array")
        super().__init__(DoubleType(), 0, int(most or 10_000_000))
        self.text = f"array({code}; {most})" if most else f"array({code})"
        self.noun, self.plural, self.annotation = "an array of numbers", "arrays", "array[float]"


def lasting(type_: Type) -> Atom | Composite:
    """The type without a question mark."""
    return cast("Atom | Composite", type_.inner if isinstance(type_, OptionalType) else type_)


def atoms(type_: Type) -> Iterator[Atom]:
    """The atoms that a type is made of."""
    inner = lasting(type_)
    if isinstance(inner, Atom):
        yield inner
    else:
        for part in inner.made_of:
            yield from atoms(part)


def is_pair(type_: Type) -> bool:
    """Whether values are points or vectors in the plane."""
    return isinstance(type_, TupleType) and type_.is_vector and len(type_.made_of) == 2


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
