"""A function or class in another language, written by the rules of the table `[spell]` of its description.

A rule is a text with holes; or a text for each kind of type, `any` for the others; or a list of three: a
text for each of the `parameters`, `structs`, `lacking` structs, `fields` or `parts`, or once where there are
`big` integers, or `digits` or `bools` in the answer, and what stands between. Of a class it may be one for
each of its `methods`, written as a function is, or its `members`: its constructor, of kind `made`, and
these. A hole `{rule}` is written for the type at hand, `{inner.rule}` for what a list or an optional value
is of, `{answer.rule}` for the answer as the problem has it. What no rule and no name of `Writer` fits stays
as it is. The rule `driver` is what the driver's file is called where it is compiled, `judge_driver.*`
without it. The driver has holes `@rule@`, and parts for some functions alone:

    // @if big        or // @if not big, digits, bools, methods
    …
    // @end
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from copy import copy
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

from judge.errors import JudgeError
from judge.languages.model import Language
from judge.languages.shapes import Shape, Unsupported
from judge.languages.spec import Spec, small

_HOLE = re.compile(r"\{(?:(inner|answer)\.)?(\w+)\}")
_DRIVER_HOLE = re.compile(r"@(?:(inner|answer)\.)?(\w+)@")
_SECTION = re.compile(r"^[^\w\n]*@if (not )?(\w+)\n(.*?)^[^\w\n]*@end\n", re.MULTILINE | re.DOTALL)
_MOST = 100_000  # items of an answer, where room for them is made before
_Values = Mapping[str, str]
T = TypeVar("T")


class Writer:
    """The texts of one function in one language.

    A hook is a module beside the description. Each function of it is a rule: it is given this writer and the
    type at hand. Two are none: `adapted` is given the submission's bytes and returns what is compiled,
    `finished` does so with the driver's text.
    """

    def __init__(self, language: Language, spec: Spec) -> None:
        """Raises Unsupported for a language without a driver, JudgeError for a hook that cannot be used."""
        self.spec = spec
        self._language = language
        self._path, self._driver = _driver(language.folder)
        self._hook = _hook(language)

    def __contains__(self, rule: str) -> bool:
        return rule in self._hook or rule in self._language.spell

    def text(self, rule: str, shape: Shape | None = None) -> str:
        """What a rule comes to; for the answer, one integer of which is the machine's, without a type.

        Raises:
            Unsupported: the language has no form of a type.
            JudgeError: there is no such rule, or it fails.
        """
        return self._guarded(rule, lambda: self.write(rule, shape or small(self.spec.answer)))

    def driver(self) -> tuple[str, str]:
        """The driver's file name and its text. Raises as `text`."""
        name = str(self._language.spell.get("driver", f"judge_{self._path.name}"))
        return name, self._guarded("driver", lambda: self._filled_driver(small(self.spec.answer)))

    def adapted(self, source: bytes) -> bytes:
        """The submission's own file as it is compiled beside the driver."""
        return self._guarded("file", lambda: bytes(self._hook.get("adapted", bytes)(source)))

    def write(self, rule: str, shape: Shape, **values: str) -> str | None:
        """What a rule comes to for a type; None where there is none. `values` are names of the place.

        Names are `entry`, `file`; of a type its `kind`, its `name` and its `most` items; of a parameter its
        `parameter`, that in lower case `lower`, and the driver's `argument`; of a field its `field`; of a
        method its name in the problem, `called`.
        """
        if rule in values:
            return values[rule]
        if rule in self._hook:
            return str(self._hook[rule](self, shape))
        found = self._language.spell.get(rule)
        if isinstance(found, dict):
            many = f"{shape.inner.kind}s" if shape.packed else ""
            found = found.get(many, found.get(shape.kind, found.get("any")))
            if found is None:
                raise Unsupported(shape.kind)
        if isinstance(found, str):
            return self._filled(_HOLE, found, shape, values)
        if found:
            over, item, between = found
            places = self._places(over, shape)
            return between.join(
                writer._filled(_HOLE, item, each, {**values, **more}) for writer, each, more in places
            )
        return self._name(rule, shape)

    def _name(self, rule: str, shape: Shape) -> str | None:
        if rule == "most" and (shape.most is None or shape.most > _MOST):
            raise Unsupported("a list of any length")
        spec = self.spec
        names = {"entry": spec.entry, "file": spec.file, "kind": shape.kind, "name": shape.name}
        return str(shape.most) if rule == "most" else names.get(rule)

    def _places(self, over: str, shape: Shape) -> Iterator[tuple[Writer, Shape, _Values]]:
        """Each type that a rule is written for, with its writer and the names of its place."""
        if over == "parameters":
            for place, (name, each) in enumerate(self.spec.parameters):
                yield self, each, {"parameter": name, "lower": name.lower(), "argument": f"judge{place}"}
        elif over == "fields":
            for each, name in zip(shape.parts, shape.fields, strict=False):
                yield self, each, {"field": name}
        elif over in ("methods", "members"):
            for name, spec in getattr(self.spec, over):
                writer = copy(self)
                writer.spec = spec
                yield writer, small(spec.answer), {"called": name}
        else:
            lists = {"parts": shape.parts, "structs": self.spec.structs, "lacking": self.spec.lacking}
            yield from ((self, each, {}) for each in lists.get(over, (shape,) if self.spec.has(over) else ()))

    def _filled(self, pattern: re.Pattern[str], text: str, shape: Shape, values: _Values) -> str:
        def hole(found: re.Match[str]) -> str:
            inner = shape.inner if found[1] == "inner" else self.spec.answer if found[1] else shape
            made = self.write(found[2], inner, **values)
            return found[0] if made is None else made

        return pattern.sub(hole, text)

    def _filled_driver(self, answer: Shape) -> str:
        def section(found: re.Match[str]) -> str:
            return found[3] if self.spec.has(found[2]) != bool(found[1]) else ""

        text = self._filled(_DRIVER_HOLE, _SECTION.sub(section, self._driver), answer, {})
        return str(self._hook.get("finished", str)(text))

    def _guarded(self, what: str, made: Callable[[], T | None]) -> T:
        """What is made; its own faults are one clear line."""
        try:
            found = made()
        except (Unsupported, JudgeError):
            raise
        except Exception as fault:  # foreign code: whatever it raises
            told = f"{self._language.name}'s {what} cannot be written: {type(fault).__name__}: {fault}"
            raise JudgeError(told, where=self._language.folder, remedy="correct it") from fault
        if found is None:
            remedy = "define what 'judge help programs' says"
            raise JudgeError(f"spell has no {what}", where=self._language.folder, remedy=remedy)
        return found


@cache
def _driver(folder: str) -> tuple[Path, str]:
    path = next(Path(folder).glob("driver.*"), None)
    if path is None:
        raise Unsupported(folder)
    return path, path.read_text(encoding="utf-8")


@cache
def _hook(language: Language) -> dict[str, Any]:
    path = Path(language.folder) / "hook.py"
    if not path.is_file():
        return {}
    names: dict[str, Any] = {"__name__": f"judge_hook_{language.id}"}
    try:
        exec(compile(path.read_bytes(), path, "exec"), names)
    except Exception as fault:  # foreign code: whatever it raises is one clear line
        what = f"the hook of {language.name} cannot be loaded: {type(fault).__name__}: {fault}"
        raise JudgeError(what, where=str(path), remedy="correct it") from fault
    return {
        name: made for name, made in names.items() if getattr(made, "__module__", "") == names["__name__"]
    }
