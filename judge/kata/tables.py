"""Reading the small TOML files beside the problems: practice sets and skills. Every fault has its line."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, TypeVar, assert_never

import msgspec

from judge.errors import ProblemError, nearest
from judge.problem.lines import key_lines, line_of
from judge.problem.text import read_text
from judge.problem.toml import read_toml

if TYPE_CHECKING:
    from judge.problem.shape import Misfit

T = TypeVar("T")


class Table:
    """One such file."""

    def __init__(self, path: Path) -> None:
        self._name = f"{path.parent.name}/{path.name}"
        self._path = path
        self._text = read_text(path)

    def fault(self, what: str, remedy: str, *path: str | int) -> ProblemError:
        """The fault of what stands at `path` in the file."""
        return self._at(line_of(path, key_lines(self._text)), what, remedy)

    def read(self, shape: type[T]) -> T:
        """The file in its shape. Raises ProblemError."""
        raw = read_toml(self._path, self._text, self._name)
        try:
            return msgspec.convert(raw, shape)
        except msgspec.ValidationError as why:
            from judge.problem.shape import refused  # most files are as they should be

            raise self._misshapen(refused(raw, shape, (), why)) from None

    def _misshapen(self, found: Misfit) -> ProblemError:
        from judge.problem.shape import Missing, NoChoice, Unknown, WrongKind

        path = found.path
        name = next((part for part in reversed(path) if isinstance(part, str)), "the file")
        if isinstance(found, Unknown):
            return self.fault(
                f"unknown key {found.key!r}", "remove it, or correct its name", *path, found.key
            )
        if isinstance(found, Missing):
            return self.fault(f"the key {found.key!r} is missing", f"add {found.key} = …", *path)
        if isinstance(found, NoChoice):
            return self.fault(f"{name} = {found.given!r} is unknown", f"use one of {found.choice}", *path)
        if isinstance(found, WrongKind):
            return self.fault(f"{name} is {found.given}", f"give {found.wanted}", *path)
        assert_never(found)

    def _at(self, line: int, what: str, remedy: str) -> ProblemError:
        return ProblemError(what, where=f"{self._name}:{line}", remedy=remedy)


def unlike_any(name: str, names: list[str]) -> str:
    """What to do about a name that is none of `names`."""
    meant = nearest(name, names)
    return f"did you mean {meant!r}?" if meant else f"there are {', '.join(names) or 'none'}"
