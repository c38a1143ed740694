"""What is wrong with the shape of a TOML file's tables, where msgspec refuses them.

msgspec is quick and says what is wrong in words of its own; a person needs the key, its line and ours. So
what it refuses is looked through once more, in its order.
"""

from __future__ import annotations

from collections.abc import Iterator
from datetime import date, datetime, time
from decimal import Decimal
from typing import Any, NamedTuple

import msgspec
from msgspec import inspect

from judge.problem.lines import KeyPath

_NAMES: tuple[tuple[type, str], ...] = (  # in this order: a bool is an int too
    (bool, "true or false"),
    (int, "a whole number"),
    (float, "a number with a point"),
    (Decimal, "a number with a point"),
    (str, "text"),
    (list, "a list"),
    (dict, "a table"),
    (datetime, "a date and time"),
    (date, "a date"),
    (time, "a time"),
)


class Unknown(NamedTuple):
    """A key that the table at `path` cannot have."""

    path: KeyPath
    key: str


class Missing(NamedTuple):
    """A key that the table at `path` must have."""

    path: KeyPath
    key: str
    table: dict[str, Any]


class NoChoice(NamedTuple):
    """A text that is none of the few that may stand at `path`."""

    path: KeyPath
    given: str
    choice: tuple[str, ...]


class WrongKind(NamedTuple):
    """A value of another kind than is meant at `path`; both in words, "a list"."""

    path: KeyPath
    wanted: str
    given: str


Misfit = Unknown | Missing | NoChoice | WrongKind


def misfit(raw: Any, shape: Any, path: KeyPath = ()) -> Misfit | None:
    """The first thing by which `raw`, which stands at `path`, is not of that shape."""
    return next(_misfits(raw, inspect.type_info(shape), path), None)


def _misfits(raw: Any, kind: inspect.Type, path: KeyPath) -> Iterator[Misfit]:
    if isinstance(kind, inspect.UnionType):
        fitting = next((each for each in kind.types if _is_of(raw, each)), None)
        if fitting is None:
            yield WrongKind(path, _wanted(kind), _given(raw))
        else:
            yield from _misfits(raw, fitting, path)
    elif not _is_of(raw, kind):
        yield WrongKind(path, _wanted(kind), _given(raw))
    elif isinstance(kind, inspect.StructType):
        yield from _of_table(raw, kind, path)
    elif isinstance(kind, inspect.ListType):
        for at, each in enumerate(raw):
            yield from _misfits(each, kind.item_type, (*path, at))
    elif isinstance(kind, inspect.DictType):
        for key, each in raw.items():
            yield from _misfits(each, kind.value_type, (*path, key))
    elif isinstance(kind, inspect.EnumType) and raw not in _choice(kind):
        yield NoChoice(path, raw, _choice(kind))


def _of_table(raw: dict[str, Any], kind: inspect.StructType, path: KeyPath) -> Iterator[Misfit]:
    fields = {field.encode_name: field for field in kind.fields}
    for key, each in raw.items():
        if key in fields:
            yield from _misfits(each, fields[key].type, (*path, key))
        else:
            yield Unknown(path, key)
    for name, field in fields.items():
        if field.required and name not in raw:
            yield Missing(path, name, raw)


def _is_of(raw: Any, kind: inspect.Type) -> bool:
    """Whether a value is of that kind, whatever it holds."""
    if isinstance(kind, inspect.AnyType):
        return True
    types = _types(kind)
    return isinstance(raw, types) and (bool in types or not isinstance(raw, bool))


def _types(kind: inspect.Type) -> tuple[type, ...]:
    """The types of values of a kind, as tomllib gives them."""
    if isinstance(kind, inspect.StructType | inspect.DictType):
        return (dict,)
    if isinstance(kind, inspect.ListType):
        return (list,)
    if isinstance(kind, inspect.StrType | inspect.EnumType):
        return (str,)
    if isinstance(kind, inspect.BoolType):
        return (bool,)
    if isinstance(kind, inspect.IntType):
        return (int,)
    if isinstance(kind, inspect.DecimalType | inspect.FloatType):
        return (int, float, Decimal)
    if isinstance(kind, inspect.NoneType):
        return ()  # TOML has no null
    raise NotImplementedError(f"{kind} in the shape of a TOML file")


def _choice(kind: inspect.EnumType) -> tuple[str, ...]:
    return tuple(member.value for member in kind.cls)


def _wanted(kind: inspect.Type) -> str:
    """What is meant: the widest of the types that will do."""
    kinds = kind.types if isinstance(kind, inspect.UnionType) else (kind,)
    types = {each for one in kinds for each in _types(one)}
    return "a number" if {int, Decimal} <= types else _named(next(iter(types)))


def _given(raw: Any) -> str:
    return next((name for type_, name in _NAMES if isinstance(raw, type_)), type(raw).__name__)


def _named(type_: type) -> str:
    return dict(_NAMES)[type_]


def refused(raw: Any, shape: Any, path: KeyPath, why: msgspec.ValidationError) -> Misfit:
    """`misfit` of what msgspec has refused."""
    found = misfit(raw, shape, path)
    assert found is not None, f"msgspec alone refuses it: {why}"
    return found
