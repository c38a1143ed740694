"""The language of types, as `answer` and `type` of problem.toml are written in it.

    type  =  base ["?"]                                  with "?" the value may also be None
    base  =  name [ "(" argument … ")" ]                 an atom, or a name that stands for another type
          |  name [ "(" low ".." high ")" ]              an int, a real or a text with its bounds
          |  "(" type "," type … ")"                     a tuple of fixed parts
          |  "[" type [ ";" n | ";" low ".." high ] "]"  a list
          |  "{" key ":" type [ … as of a list ] "}"     a dict; the keys are ints, words, texts or bools
          |  "calls{" method ";" method … "}"            calls in a row, and "returns{…}" what they return
    method =  name "(" name ":" type "," … ")" [ "->" type ]

Names are looked up here and in the pack's own folder `types`; an argument is a word or a number, and
arguments are parted by "|", ";" or ",". A file of a pack has as its TYPE what makes the type, called with the
arguments, or a text of the language, for which its name then stands.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any, TypeVar

from judge.errors import nearest
from judge.values.answers import NO_WORDS, Words
from judge.values.atoms import COORDINATES, IntType, RealType, Type
from judge.values.letters import BoolType, TextType, WordType, texts_of
from judge.values.types import ArrayType, DictType, ListType, OptionalType, TupleType, lasting

_MOST_TEXT = 2_000  # characters of a type's text
_TOKEN = re.compile(r"[A-Za-z_](?:\w|-(?!>))*|\d+|\.\.|->|\S", re.ASCII)
_FOREIGN = re.compile(r"[^\w\s()\[\],;?|.{}:>-]", re.ASCII)
_LENGTH = re.compile(r"[0-9]{1,9}")
_WHOLE = re.compile(r"-?[0-9]{1,400}")
_DEEPEST = 12
_T = TypeVar("_T")

# What a name stands for: another text of the language, or what makes the type.
NAMES: dict[str, str | Callable[..., Type]] = {
    "count": "int?",
    "points": "[vec2; 0..2]",
    "parameter": "real?",
    "number": "real",
    "integer": "int",
    "point": "vec2",
    "point3": "vec3",
    "vec2": lambda: TupleType((RealType(), RealType()), COORDINATES[:2], "Point"),
    "vec3": lambda: TupleType((RealType(), RealType(), RealType()), COORDINATES, "Point3"),
    "integer-point": lambda: TupleType((IntType(), IntType()), COORDINATES[:2], "IntPoint"),
    "int": IntType,
    "real": RealType,
    "word": WordType,
    "text": TextType,
    "bool": BoolType,
    "array": ArrayType,
}
_BOUNDED: dict[str, Callable[..., Type]] = {"int": IntType, "real": RealType, "text": TextType}

# What people write who know other languages, and what it is called here.
_ELSEWHERE = {
    "float double decimal": "real",
    "str string": "text(low..high)",
    "boolean": "bool",
    "enum": "word(a|b)",
    "list vector": "[T]",
    "tuple pair": "(T, T)",
    "dict map mapping Dict": "{K: V}",
    "class": "[methods]",
    "none null optional Optional None": "T?",
}


class TypeFault(ValueError):  # noqa: N818 - a fault of the text
    """A text that is not a type: what is wrong, and what to do about it."""

    def __init__(self, what: str, remedy: str = "write it as a name, (T, T), [T; low..high] or T?") -> None:
        super().__init__(what)
        self.what = what
        self.remedy = remedy


def parse(text: str, folder: Path | None = None, words: Words = NO_WORDS, letters: str = "") -> Type:
    """The type that a text stands for; `folder` holds a pack's own types, its texts are of these `letters`.

    Raises TypeFault.
    """
    if len(text) > _MOST_TEXT:
        raise TypeFault(f"a text of {len(text):,} characters is not a type", "write a shorter one")
    found = _Parser(text, folder).whole()
    found.text = text.strip()
    if words.parts:
        _name_parts(found, tuple(words.parts.split(", ")))
    found.folder, found.words = folder, words
    for each in (found, *texts_of(found)):
        each.letters = letters
    return found


def _name_parts(type_: Type, names: tuple[str, ...]) -> None:
    inner = lasting(type_)
    if not isinstance(inner, TupleType) or len(inner.made_of) != len(names):
        raise TypeFault(f"{type_.text} has no {len(names)} parts", "give words.parts one name for each part")
    inner.told = names


class _Parser:
    """One text, read from left to right. A ValueError says what is wrong."""

    def __init__(self, text: str, folder: Path | None, depth: int = 0) -> None:
        self._text = text.strip()
        self._folder = folder
        self._depth = depth
        self._tokens = _TOKEN.findall(text)

    def whole(self) -> Type:
        """The type of the whole text. Raises TypeFault."""
        try:
            if foreign := _FOREIGN.search(self._text):
                raise ValueError(f"{foreign[0]!r} belongs in no type")
            found = self._type()
            if self._tokens:
                raise ValueError(f"{self._tokens[0]!r} comes after its end")
        except TypeFault:
            raise
        except ValueError as why:
            raise TypeFault(f"{self._text!r} is not a type: {why}") from None
        return found

    def _next(self, wanted: str = "") -> str:
        token = self._tokens.pop(0) if self._tokens else ""
        if not token or (wanted and token != wanted):
            found = repr(token) if token else "its end"
            raise ValueError(f"{found} where {repr(wanted) if wanted else 'a type'} is expected")
        return token

    def _take(self, token: str) -> bool:
        return self._tokens[:1] == [token] and bool(self._tokens.pop(0))

    def _type(self) -> Type:
        self._depth += 1
        if self._depth > _DEEPEST:
            raise ValueError("it is nested too deep")
        found: Type
        token = self._next()
        if token == "(":
            found = TupleType(self._several(self._type, ",", ")"))
        elif token == "[":
            found = ListType(self._type(), *self._lengths("]"))
        elif token == "{":
            key = self._type()
            self._next(":")
            found = DictType(key, self._type(), *self._lengths("}"))
        elif token in _BOUNDED:
            found = self._bounded(token)
        elif token in ("calls", "returns") and self._take("{"):
            found = self._in_a_row(token)
        elif token.replace("-", "_").isidentifier():
            found = self._named(token)
        else:
            raise ValueError(f"none begins with {token!r}")
        self._depth -= 1
        return OptionalType(found) if self._take("?") else found

    def _several(self, each: Callable[[], _T], between: str, end: str) -> list[_T]:
        """What is parted by any of these signs, up to the one that closes it."""
        found = [each()]
        while not self._take(end):
            if not any(map(self._take, between)):
                self._next(end)  # it is no such sign
            found.append(each())
        return found

    def _lengths(self, end: str) -> tuple[int, int | None]:
        """How many items there may be, up to the closing sign."""
        low, high = 0, None
        if self._take(";"):
            low = high = self._length()
            if self._take(".."):
                high = self._length()
        self._next(end)
        return low, high

    def _in_a_row(self, what: str) -> Type:
        from judge.values.calls import CallType, Method, ReturnType

        kind: type[CallType | ReturnType] = CallType if what == "calls" else ReturnType
        return kind([Method(*each) for each in self._several(self._method, ";", "}")])

    def _method(self) -> tuple[str, tuple[tuple[str, Type], ...], Type | None]:
        """A name, what it takes, and what it answers."""
        name = self._next()
        self._next("(")
        takes = [] if self._take(")") else self._several(self._parameter, ",", ")")
        if not all(each.isidentifier() for each in (name, *(word for word, _ in takes))):
            raise ValueError(f"{name} and its parameters need plain names")
        return name, tuple(takes), self._type() if self._take("->") else None

    def _parameter(self) -> tuple[str, Type]:
        name = self._next()
        self._next(":")
        return name, self._type()

    def _length(self) -> int:
        token = self._next()
        if not _LENGTH.fullmatch(token):
            raise ValueError(f"{token!r} is not a length of a list")
        return int(token)

    def _bounded(self, name: str) -> Type:
        """An int, a real or a text; `text(5)` is as long as that."""
        self._known(name)
        if not self._take("("):
            return _BOUNDED[name]()
        low = high = self._bound()
        if self._take(".."):
            high = self._bound()
        elif name != "text":
            raise TypeFault(f"{self._text!r} is not a type", f"give both bounds, {name}(low..high)")
        self._next(")")
        try:
            return _BOUNDED[name](low, high)
        except ValueError as why:
            what = f"{self._text!r} is not a type: {why}"
            raise TypeFault(what, f"write {name}(low..high), the smaller one first") from None

    def _bound(self) -> int:
        sign = "-" if self._take("-") else ""
        token = sign + self._next()
        if not _WHOLE.fullmatch(token):
            raise ValueError(f"{token!r} is not a whole number")
        return int(token)

    def _known(self, name: str) -> None:
        """Raise TypeFault where a file of the pack has the name of a type of the judge, which hides it."""
        if self._folder and (self._folder / f"{name}.py").is_file():
            what = f"types/{name}.py is not used: {name} is a type of the judge"
            raise TypeFault(what, "rename or remove it")

    def _named(self, name: str) -> Type:
        """The type of that name."""
        if name in NAMES:
            self._known(name)
        found = NAMES.get(name) or _found(name, self._folder)
        if found is None:
            raise self._unknown(name)
        arguments = self._several(self._next, "|;,", ")") if self._take("(") else []
        if isinstance(found, str):
            if arguments:
                raise ValueError(f"{name} takes nothing in parentheses")
            return _Parser(found, self._folder, self._depth).whole()
        try:
            made: Type = found(*arguments)
        except TypeError:
            raise ValueError("there are too many or too few words between its parentheses") from None
        return made

    def _unknown(self, name: str) -> TypeFault:
        files = sorted(self._folder.glob("[a-z]*.py")) if self._folder else []
        own = [*NAMES, *(path.stem.replace("_", "-") for path in files)]
        elsewhere = (meant for names, meant in _ELSEWHERE.items() if name in names.split())
        meant = next(elsewhere, None) or nearest(name, own)
        if meant in _BOUNDED and (bounds := re.search(rf"\b{name}(\([-0-9.]*\))", self._text)):
            meant += bounds[1]
        remedy = f"did you mean {meant!r}?" if meant else f"use one of {', '.join(own)}"
        what = f"{name!r} is unknown"
        return TypeFault(what if self._text == name else f"{self._text!r} is not a type: {what}", remedy)


def _found(name: str, folder: Path | None) -> Any:
    """What a pack's module of that name has as its TYPE; None where there is no such module."""
    if folder is None or not re.fullmatch(r"[a-z][a-z0-9-]{0,99}", name):
        return None
    path = folder / f"{name.replace('-', '_')}.py"
    if not path.is_file():
        return None
    module = ModuleType(f"judge_type_{path.stem}_{abs(hash(path)):x}")
    module.__file__ = str(path)
    try:
        exec(compile(path.read_text(encoding="utf-8"), str(path), "exec", dont_inherit=True), module.__dict__)
        return module.TYPE
    except Exception as fault:  # trusted, but anybody's
        what = f"types/{path.name} cannot be loaded: {type(fault).__name__}: {fault}"
        raise TypeFault(what, "repair it there; it must define TYPE") from fault
