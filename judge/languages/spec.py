"""What a driver is made from: the function as its language spells it, and what the source brings itself."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from functools import cache
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

from judge.errors import JudgeError
from judge.languages.model import Language
from judge.languages.scan import met
from judge.languages.shapes import Shape, Unsupported, shape_of, structs
from judge.languages.signature import Signature

DRIVER = ("declared", "frame", "driver")  # what its module defines, see judge.languages.drivers
_BRACES = re.compile(r"'.'|[{}]|\b(?:class|record|interface|enum)\s++(\w++)")
_TYPEDEFS = re.compile(r"\btypedef\b([^;{}]*+)(;?)")


class Spec(NamedTuple):
    """One function in one language.

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

    @property
    def is_big(self) -> bool:
        """Whether some of its integers may be of any size."""
        return any(map(is_big, (*(shape for _, shape in self.parameters), self.answer)))

    @property
    def arguments(self) -> list[str]:
        """A name in the driver for each argument."""
        return [f"judge{place}" for place in range(len(self.parameters))]


def spec_of(language: Language, signature: Signature, text: str = "", file: str = "") -> Spec:
    """A problem's function. Raises Unsupported for a type that no driver knows."""
    parameters = tuple((name, shape_of(type_, big=signature.big)) for name, type_ in signature.parameters)
    answer = shape_of(signature.answer, big=signature.big)
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
    return shape.kind == "big" or any(map(is_big, shape.parts))


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


@cache
def driver_of(language: Language) -> Any:
    """The module that writes a language's drivers, of one's own language the file beside its description.

    Raises Unsupported where there is none, and JudgeError where it cannot be used.
    """
    if language.folder:
        return _foreign(language, Path(language.folder) / f"{language.id}.py")
    if not (Path(__file__).parent / "drivers" / f"{language.id}.py").is_file():
        raise Unsupported(language.id)
    return import_module(f"judge.languages.drivers.{language.id}")


def _foreign(language: Language, path: Path) -> Any:
    if not path.is_file():
        raise Unsupported(language.id)
    module = ModuleType(f"judge_driver_{language.id}")
    module.__file__ = str(path)
    try:
        exec(compile(path.read_bytes(), path, "exec"), vars(module))
    except Exception as fault:  # foreign code: whatever it raises is one clear line
        what = f"the driver of {language.name} cannot be loaded: {type(fault).__name__}: {fault}"
        raise JudgeError(what, where=str(path), remedy="correct it") from fault
    lacking = [name for name in DRIVER if not callable(getattr(module, name, None))]
    if lacking:
        what = f"the driver of {language.name} has no {' and no '.join(lacking)}"
        raise JudgeError(what, where=str(path), remedy="define what 'judge help programs' says")
    for name in DRIVER:
        setattr(module, name, _guarded(getattr(module, name), f"{language.name}'s {name}", path))
    return module


def _guarded(made: Callable[..., Any], what: str, path: Path) -> Callable[..., Any]:
    """The function, whose own faults are one clear line."""

    def called(*arguments: Any) -> Any:
        try:
            return made(*arguments)
        except (Unsupported, JudgeError):
            raise
        except Exception as fault:
            told = f"{what} fails: {type(fault).__name__}: {fault}"
            raise JudgeError(told, where=str(path), remedy="correct it") from fault

    return called


def listed(words: Iterable[str]) -> str:
    """The words with commas between them."""
    return ", ".join(words)


def joined(shapes: Iterable[Shape], write: Callable[[Shape], str], between: str = "\n") -> str:
    """What is written for each shape, one after the other."""
    return between.join(map(write, shapes))
