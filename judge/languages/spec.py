"""What a driver is written from: a problem's function, and what the source brings itself."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from judge.languages.model import Language
from judge.languages.scan import met
from judge.languages.shapes import Shape, Unsupported, shape_of, structs
from judge.languages.signature import Signature
from judge.values.atoms import Type

_BRACES = re.compile(r"'.'|[{}]|\b(?:class|record|interface|enum)\s++(\w++)")
_TYPEDEFS = re.compile(r"\btypedef\b([^;{}]*+)(;?)")


class Spec(NamedTuple):
    """One function or class, for one source in one language.

    Of a class the parameters are its constructor's, and its `methods` have each the name in the problem and a
    spec of its own, whose answer is "nothing" where nobody looks. `structs` are the tuples that it needs;
    those that the source defines itself are in `own`. `text` is the source without comments and strings,
    `file` what it is called where it is compiled.
    """

    entry: str
    parameters: tuple[tuple[str, Shape], ...]
    answer: Shape
    structs: tuple[Shape, ...]
    own: frozenset[str]
    text: str
    file: str
    methods: tuple[tuple[str, Spec], ...] = ()

    @property
    def members(self) -> tuple[tuple[str, Spec], ...]:
        """Of a class its constructor, whose answer is "made", and its methods."""
        return ("", self._replace(answer=Shape("made"), methods=())), *self.methods

    @property
    def lacking(self) -> list[Shape]:
        """The tuples that the driver has to define."""
        return [each for each in self.structs if each.name not in self.own]

    def has(self, what: str) -> bool:
        """Whether it has methods, some of its integers may be of any size ("big"), of its answers ("digits"),
        it answers bools, or there are dicts."""
        if what == "methods":
            return bool(self.methods)
        every = (self, *(each for _, each in self.methods))
        if kind := {"big": "big", "dicts": "dict"}.get(what):
            return any(_holds(shape, kind) for each in every for shape in each.shapes)
        return any(is_big(each.answer) if what == "digits" else _holds(each.answer, "bool") for each in every)

    @property
    def shapes(self) -> Iterator[Shape]:
        """Of its parameters and its answer."""
        yield from (shape for _, shape in self.parameters)
        yield self.answer


def spec_of(language: Language, signature: Signature, text: str = "", file: str = "") -> Spec:
    """A problem's function or class. Raises Unsupported for a type that no driver knows, and for a class in a
    language that calls none."""
    if signature.methods and not language.classes:
        raise Unsupported("a class")

    def spec(name: str, takes: Iterable[tuple[str, Type]], answer: Shape) -> Spec:
        parameters = tuple((each, shape_of(type_, big=signature.big)) for each, type_ in takes)
        return Spec(language.spelt(name), parameters, answer, (), frozenset(), text, file)

    def answered(type_: Type | None) -> Shape:
        return shape_of(type_, big=signature.big) if type_ else Shape("nothing")

    methods = [(each.name, spec(each.name, each.takes, answered(each.answer))) for each in signature.methods]
    made = Shape("class") if methods else answered(signature.answer)
    whole = spec(signature.entry, signature.parameters, made)
    every = [whole, *(each for _, each in methods)]
    if any(is_big(each.answer) for each in every) and any(_holds(each.answer, "text") for each in every):
        raise Unsupported("a text beside ints of any size, which are texts too")
    named = tuple(structs(shape for each in every for shape in each.shapes))
    own = frozenset(each.name for each in named if _defines(each.name, text))
    methods = [(name, each._replace(structs=named, own=own)) for name, each in methods]
    return whole._replace(structs=named, own=own, methods=tuple(methods))


def small(answer: Shape) -> Shape:
    """The answer as an int of the machine where it is one of any size: most of them are counts and signs."""
    if answer.kind == "optional":
        return answer._replace(parts=(small(answer.inner),))
    return Shape("int") if answer.kind == "big" else answer


def is_big(shape: Shape) -> bool:
    """Whether an int of any size is within."""
    return _holds(shape, "big")


def _holds(shape: Shape, kind: str) -> bool:
    return shape.kind == kind or any(_holds(part, kind) for part in shape.parts)


def _defines(name: str, text: str) -> bool:
    forms = (
        rf"\b(?:struct|class|record|type|using)\s++{name}\b",
        rf"\}}\s*+{name}\s*+;",
        rf"^[ \t]*+{name}\s++(?:struct\b|=)",
    )
    if re.search("|".join(forms), text, re.MULTILINE):
        return True
    typedefs = (found[1].replace(">", " ").split() for found in _TYPEDEFS.finditer(text) if found[2])
    return any(words[-1:] == [name] for words in typedefs)


def around(text: str, place: int) -> str:
    """The outermost class, or what is like one, around a place of a source; empty where there is none."""
    depth, name = 0, ""
    for found in met(_BRACES, text, place):
        if found[1]:
            name = name if depth else found[1]
        elif found[0] in "{}":
            depth += 1 if found[0] == "{" else -1
    return name if depth else ""
