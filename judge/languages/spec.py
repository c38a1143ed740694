"""What a driver is written from: a problem's function, and what the source brings itself."""

from __future__ import annotations

import re
from typing import NamedTuple

from judge.languages.model import Language
from judge.languages.scan import met
from judge.languages.shapes import Shape, Unsupported, shape_of, structs
from judge.languages.signature import Signature

_BRACES = re.compile(r"'.'|[{}]|\b(?:class|record|interface|enum)\s++(\w++)")
_TYPEDEFS = re.compile(r"\btypedef\b([^;{}]*+)(;?)")


class Spec(NamedTuple):
    """One function, for one source in one language.

    `structs` are the tuples that it needs; those that the source defines itself are in `own`. `text` is the
    source without comments and strings, `file` what it is called where it is compiled.
    """

    entry: str
    parameters: tuple[tuple[str, Shape], ...]
    answer: Shape
    structs: tuple[Shape, ...]
    own: frozenset[str]
    text: str
    file: str

    @property
    def lacking(self) -> list[Shape]:
        """The tuples that the driver has to define."""
        return [each for each in self.structs if each.name not in self.own]

    def has(self, what: str) -> bool:
        """Whether some of its integers may be of any size ("big"), or of its answer ("digits"), or bools."""
        if what == "big":
            return any(map(is_big, (*(shape for _, shape in self.parameters), self.answer)))
        return is_big(self.answer) if what == "digits" else _holds(self.answer, "bool")


def spec_of(language: Language, signature: Signature, text: str = "", file: str = "") -> Spec:
    """A problem's function. Raises Unsupported for a type that no driver knows."""
    parameters = tuple((name, shape_of(type_, big=signature.big)) for name, type_ in signature.parameters)
    answer = shape_of(signature.answer, big=signature.big)
    if is_big(answer) and _holds(answer, "text"):
        raise Unsupported("a text beside ints of any size, which are texts too")
    named = tuple(structs([*(shape for _, shape in parameters), answer]))
    own = frozenset(each.name for each in named if _defines(each.name, text))
    return Spec(language.spelt(signature.entry), parameters, answer, named, own, text, file)


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
