"""Types made of others: tuples, lists, and what may be None."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

from judge.values.atoms import IntType, RealType
from judge.values.base import (
    COORDINATES,
    LONGEST,
    MANY_LENGTHS,
    NOTHING,
    Place,
    Quick,
    Target,
    Type,
)
from judge.values.wire import Raw, items


class OptionalType(Type):
    """`T?`: None, or what `inner` says."""

    optional = True

    def __init__(self, inner: Type) -> None:
        if inner.optional or (isinstance(inner, TupleType) and inner.begins_optional):
            raise ValueError("as text it does not say whether all of it is none or only its first part")
        self.inner = inner
        self.text, self.noun = f"{inner.text}?", f"{inner.noun} or None"
        self.measured, self.settled, self.is_answer = inner.measured, inner.settled, inner.is_answer
        self.is_parameter, self.is_plain = inner.is_parameter, inner.is_plain
        self.width = 1 if inner.width == 1 else None
        self.depth, self.most, self.lengths = inner.depth, inner.most, inner.lengths
        self.plural, self.one, self.several = inner.plural, inner.one, inner.several
        self.variable, self.annotation = inner.variable, f"{inner.annotation} | None"
        self.rounded = f"None if {{0}} is None else {inner.rounded}" if inner.rounded else ""

    @cached_property
    def quick(self) -> Quick:
        """Whether both are None, or the inner answer."""
        inner = self.inner.quick
        if isinstance(self.inner, IntType):  # asked most often
            return lambda raw, target: (
                NOTHING if raw == target and (raw is None or type(raw) is int) else None
            )

        def quick(raw: Raw, target: Target) -> float | None:
            if raw is None or target is None:
                return NOTHING if raw is target else None
            return inner(raw, target)

        return quick

    def aliases(self) -> Mapping[str, str]:
        """Those of the inner type."""
        return self.inner.aliases()


class Composite(Type):
    """A type of several parts: how many a value has is asked of `wrong_count`, what they are of `parts`."""

    kind: type[tuple[Any, ...]] | type[list[Any]]  # of an answer that was read

    def parts(self, count: int) -> Sequence[Type]:
        """The types of the parts of a value that has so many."""
        raise NotImplementedError

    def down(self, place: Place, at: int, count: int) -> Place:
        """The place of the part `at` of so many."""
        raise NotImplementedError

    def wrong_count(self, count: int, place: Place) -> str | None:
        """Why an answer cannot have so many parts."""
        raise NotImplementedError


class TupleType(Composite):
    """`(T, T, …)`: `names` are those of the parts in messages, `alias` is the stub's name for the type.

    A vector's parts are x, y and z.
    """

    kind = tuple
    plural = "tuples"

    def __init__(self, parts: Sequence[Type], names: Sequence[str] = (), alias: str = "") -> None:
        if len(parts) < 2:
            raise ValueError("a tuple has two parts or more")
        self.fixed = tuple(parts)
        self.names = tuple(names) or tuple(f"part {place}" for place in range(1, len(parts) + 1))
        self.is_vector = self.names == COORDINATES[: len(parts)]
        self.text = f"({', '.join(part.text for part in parts)})"
        self.measured = any(part.measured for part in parts)
        self.settled, self.is_answer, self.is_parameter, self.is_plain = (
            all(getattr(part, name) for part in parts)
            for name in ("settled", "is_answer", "is_parameter", "is_plain")
        )
        self.is_parameter = self.is_parameter and self.is_answer
        self.begins_optional = parts[0].optional or getattr(parts[0], "begins_optional", False)
        widths = [part.width for part in parts]
        self.width = None if None in widths else sum(filter(None, widths))
        self.depth = 1 + max(part.depth for part in parts)
        self.most = sum(part.most + (part.depth > 0) for part in parts)
        self.lengths = max(part.lengths for part in parts)
        self._alias, self._spelled = alias, f"tuple[{', '.join(part.annotation for part in parts)}]"
        self.annotation = alias or self._spelled
        self.noun = f"a {self._spelled}"  # as the file to begin with spells it
        if self.is_vector:
            self.noun, self.plural = f"({', '.join(self.names)})", "points"
            self.one, self.several = "point", "points"
        if self.measured:
            rounded = (part.rounded.format(f"{{0}}[{at}]") or f"{{0}}[{at}]" for at, part in enumerate(parts))
            self.rounded = f"({', '.join(rounded)})"

    def parts(self, count: int) -> Sequence[Type]:
        """The same always."""
        return self.fixed

    def down(self, place: Place, at: int, count: int) -> Place:
        """By its name."""
        return Place(place, at, self.names[at])

    def wrong_count(self, count: int, place: Place) -> str | None:
        """As many as there are."""
        if count == len(self.fixed):
            return None
        what = f"{count} {'coordinate' if self.is_vector else 'part'}{'' if count == 1 else 's'}"
        return f"{place.name() or 'the answer'} has {what} where {self.noun} is meant"

    @cached_property
    def quick(self) -> Quick:
        """All parts."""
        count, parts = len(self.fixed), [part.quick for part in self.fixed]

        def quick(raw: Raw, target: Target) -> float | None:
            if type(raw) is not list or len(raw) != count or type(target) is dict:
                return None
            worst = NOTHING
            for part, given, wanted in zip(parts, raw, target):  # noqa: B905  # the lengths are equal
                off = part(given, wanted)
                if off is None:
                    return None
                if off > worst:
                    worst = off
            return worst

        return quick

    def aliases(self) -> Mapping[str, str]:
        """Its own, and those of the parts."""
        inner = {name: meant for part in self.fixed for name, meant in part.aliases().items()}
        return inner | ({self._alias: self._spelled} if self._alias else {})


class ListType(Composite):
    """`[T]`, `[T; n]`, `[T; low..high]`: so many items; `high` is None where there is no bound."""

    kind = list
    width = None
    is_plain = False
    plural = "lists"

    def __init__(self, item: Type, low: int = 0, high: int | None = None) -> None:
        if high is not None and not low <= high:
            raise ValueError("the bounds leave no length: low is above high")
        self.item, self.low, self.high = item, low, high
        bounds = "" if high is None and not low else f"; {low}" if low == high else f"; {low}..{high}"
        self.text = f"[{item.text}{bounds}]"
        self.measured, self.settled, self.is_answer = item.measured, item.settled, item.is_answer
        self.is_parameter = item.is_parameter and item.is_answer
        self.depth = 1 + item.depth
        self.most = LONGEST if high is None else high * (item.most + (item.depth > 0))
        self.lengths = max(item.lengths, MANY_LENGTHS if high is None else high - low + 1)
        self.one, self.several = item.one, item.several
        self.noun, self.variable = f"a list of {item.plural}", item.several
        self.annotation = f"list[{item.annotation}]"
        if item.rounded:
            self.rounded = f"[{item.rounded.format('item')} for item in {{0}}]"
            if isinstance(item, TupleType) and item.is_vector:
                names = item.names
                parts = (
                    part.rounded.format(name) or name for part, name in zip(item.fixed, names, strict=True)
                )
                self.rounded = f"[({', '.join(parts)}) for {', '.join(names)} in {{0}}]"

    def parts(self, count: int) -> Sequence[Type]:
        """The same type for all."""
        return [self.item] * count

    def down(self, place: Place, at: int, count: int) -> Place:
        """By its number."""
        alone = count == 1 and self.one == "point" and not place.name()
        return Place(place, at, f"{self.one} {at + 1}", alone=alone)

    def bounds(self) -> str:
        """How many items there may be, in words."""
        if self.high is None:
            return f"at least {self.low}"
        if self.low == self.high:
            return str(self.low)
        return f"{self.low} to {self.high}" if self.low else f"at most {self.high}"

    def wrong_count(self, count: int, place: Place) -> str | None:
        """No more than the bound."""
        if self.high is None or count <= self.high:
            return None
        meant = f"where {self.bounds() if self.low == self.high else f'at most {self.high}'} are meant"
        return f"{place.prefix()}{count} {self.several} given {meant}"

    @cached_property
    def quick(self) -> Quick:
        """All items, one after the other."""
        item = self.item.quick

        def quick(raw: Raw, target: Target) -> float | None:
            if type(raw) is dict:  # many numbers, sent as bytes; or what is no list at all
                found = items(raw)
                raw = None if found is None else list(found)
            if type(raw) is not list or type(target) is dict or len(raw) != len(target):
                return None
            worst = NOTHING
            for given, wanted in zip(raw, target):  # noqa: B905  # the lengths are equal
                off = item(given, wanted) if type(wanted) is not dict else _any(item, given, wanted)
                if off is None:
                    return None
                if off > worst:
                    worst = off
            return worst

        return quick

    def aliases(self) -> Mapping[str, str]:
        """Those of the items."""
        return self.item.aliases()


def _any(item: Quick, given: Raw, wanted: Target) -> float | None:
    """The first of several targets that accepts an item; a run is none of them."""
    return next((off for each in wanted.get("any", ()) if (off := item(given, each)) is not None), None)


class ArrayType(ListType):
    """`array(f64; most)`: a parameter's doubles, which a submission receives as an `array.array`."""

    is_answer = False

    def __init__(self, code: str, most: str = "") -> None:
        if code != "f64":
            raise ValueError("an array holds f64")
        if most and not (most.isdecimal() and len(most) < 10):
            raise ValueError(f"{most} is no length of an array")
        super().__init__(RealType(double=True), 0, int(most) if most else 10_000_000)
        self.text = f"array({code}; {most})" if most else f"array({code})"
        self.noun, self.plural, self.annotation = "an array of numbers", "arrays", "array[float]"
        self.is_answer = False
        self.is_parameter = True


def lasting(type_: Type) -> Type:
    """The type without a question mark."""
    return type_.inner if isinstance(type_, OptionalType) else type_


def is_pair(type_: Type) -> bool:
    """Whether values are points or vectors in the plane."""
    return isinstance(type_, TupleType) and type_.is_vector and len(type_.fixed) == 2
