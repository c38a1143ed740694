"""Reading the small TOML files beside the problems: practice sets and skills. Every fault has its line."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TypeVar

import msgspec

from judge.errors import ProblemError, nearest
from judge.problem.lines import KeyPath, key_lines, line_of, parse_path
from judge.problem.text import read_text
from judge.problem.tomlfile import toml_of

T = TypeVar("T")

_UNKNOWN = re.compile(r"Object contains unknown field `(.*)`")
_MISSING = re.compile(r"Object missing required field `(.*)`")
_WRONG = re.compile(r"Expected (`.*`), got (`.*`)")
_KINDS = {
    "`str`": "text",
    "`array`": "a list",
    "`array | null`": "a list",
    "`object`": "a table",
    "`int`": "a number",
}


class Table:
    """One such file."""

    def __init__(self, path: Path) -> None:
        self._name = f"{path.parent.name}/{path.name}"
        self._text = read_text(path)

    def fault(self, what: str, remedy: str, *path: str | int) -> ProblemError:
        """The fault of what stands at `path` in the file."""
        return self._at(line_of(path, key_lines(self._text)), what, remedy)

    def read(self, shape: type[T]) -> T:
        """The file in its shape. Raises ProblemError."""
        raw = toml_of(self._text, self._name)
        try:
            return msgspec.convert(raw, shape)
        except msgspec.ValidationError as error:
            what, _, place = str(error).partition(" - at `")
            raise self._misshapen(what, parse_path(place.rstrip("`"))) from None

    def _misshapen(self, what: str, path: KeyPath) -> ProblemError:
        name = next((part for part in reversed(path) if isinstance(part, str)), "the file")
        if unknown := _UNKNOWN.fullmatch(what):
            return self.fault(
                f"unknown key {unknown[1]!r}", "remove it, or correct its name", *path, unknown[1]
            )
        if missing := _MISSING.fullmatch(what):
            return self.fault(f"the key {missing[1]!r} is missing", f"add {missing[1]} = …", *path)
        if wrong := _WRONG.fullmatch(what):
            wanted, got = (_KINDS.get(kind, kind.strip("`")) for kind in wrong.groups())
            return self.fault(f"{name} is {got}", f"give {wanted}", *path)
        return self.fault(f"{name}: {what[:1].lower()}{what[1:]}", "correct its value", *path)

    def _at(self, line: int, what: str, remedy: str) -> ProblemError:
        return ProblemError(what, where=f"{self._name}:{line}", remedy=remedy)


def unlike_any(name: str, names: list[str]) -> str:
    """What to do about a name that is none of `names`."""
    meant = nearest(name, names)
    return f"did you mean {meant!r}?" if meant else f"there are {', '.join(names) or 'none'}"
