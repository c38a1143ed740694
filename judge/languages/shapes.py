"""The types of a problem as other languages see them: few kinds, composed.

real, int, big (an int of more than 64 bits), word, text, bool      atoms
tuple (`parts` named `fields`), list, optional          of other shapes
dict (its `parts` are a key and a value)
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from judge.values.atoms import LONGEST, IntType, RealType, Type
from judge.values.letters import BoolType, TextType, WordType
from judge.values.types import ArrayType, DictType, ListType, OptionalType, TupleType

_SHORT = {"Point": "Pt", "Point3": "Pt3", "IntPoint": "IntPt"}  # as the files of many challenges call them
_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth")
_GROUPS = {2: "Pair", 3: "Triple"}


class Unsupported(Exception):  # noqa: N818 - it is caught, and the submission is a program then
    """A type that no driver knows; the text is its own."""


class Shape(NamedTuple):
    """One type; `name` is that of a tuple, `most` how many items a list may have, None where nothing says.

    A list that is `packed` is an array of numbers, where a language has them.
    """

    kind: str
    parts: tuple[Shape, ...] = ()
    fields: tuple[str, ...] = ()
    name: str = ""
    most: int | None = None
    packed: bool = False

    @property
    def inner(self) -> Shape:
        """What a list or an optional value is of."""
        return self.parts[0]


def shape_of(type_: Type, *, big: bool = False) -> Shape:
    """The shape of a type; with `big` its ints may be longer than 64 bits. Raises Unsupported."""
    if isinstance(type_, RealType):
        return Shape("real")
    if isinstance(type_, IntType):
        return Shape("big" if big else "int")
    for atom, kind in ((WordType, "word"), (TextType, "text"), (BoolType, "bool")):
        if isinstance(type_, atom):
            return Shape(kind)
    if isinstance(type_, ArrayType):
        return Shape("list", (Shape("real"),), packed=True)
    if isinstance(type_, OptionalType):
        return Shape("optional", (shape_of(type_.inner, big=big),))
    if isinstance(type_, DictType):
        key, value = shape_of(type_.key, big=big), shape_of(type_.value, big=big)
        if key.kind == "big":
            raise Unsupported("a dict whose keys are ints of any size")
        return Shape("dict", (key, value))
    if isinstance(type_, ListType):
        item = shape_of(type_.item, big=big)
        return Shape("list", (item,), most=type_.high, packed=type_.most > LONGEST and not item.parts)
    if isinstance(type_, TupleType):
        parts = tuple(shape_of(part, big=big) for part in type_.made_of)
        return Shape("tuple", parts, _fields(type_), _name(type_, parts))
    raise Unsupported(type_.text)


def structs(shapes: Iterable[Shape]) -> list[Shape]:
    """The tuples in the shapes, each once, inner ones first."""
    return list({each.name: each for shape in shapes for each in _tuples(shape)}.values())


def _tuples(shape: Shape) -> Iterator[Shape]:
    for part in shape.parts:
        yield from _tuples(part)
    if shape.kind == "tuple":
        yield shape


def _fields(type_: TupleType) -> tuple[str, ...]:
    named = all(name.isidentifier() for name in type_.names)
    return type_.names if named else _ORDINALS[: len(type_.made_of)]


def _name(type_: TupleType, parts: Iterable[Shape]) -> str:
    if type_.annotation.isidentifier():
        return _SHORT.get(type_.annotation, type_.annotation)
    names = [(part.name or part.kind).capitalize() if not part.name else part.name for part in parts]
    return _GROUPS.get(len(names), "Tuple") + "".join(names)
