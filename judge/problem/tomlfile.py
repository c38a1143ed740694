"""One problem.toml: its text, its shape, and a fault shown on the line it stands on."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn, TypeVar, assert_never

import msgspec

from judge.errors import ProblemError, nearest
from judge.problem.lines import KeyPath, key_lines, line_of
from judge.problem.model import Problem
from judge.problem.schema import ProblemTable, fields_at
from judge.problem.text import read_text
from judge.problem.toml import read_toml

if TYPE_CHECKING:
    from judge.problem.shape import Misfit

T = TypeVar("T")


class TomlFile:
    """The problem.toml of a folder. Every fault is a ProblemError with its line."""

    def __init__(self, folder: Path) -> None:
        self._name = f"{folder.name}/problem.toml"
        self._path = folder / "problem.toml"
        self._text = read_text(self._path)

    def fault(self, path: KeyPath, what: str, remedy: str) -> NoReturn:
        """Raise the fault of what stands at `path`."""
        line = line_of(path, key_lines(self._text))
        raise ProblemError(what, where=f"{self._name}:{line}", remedy=remedy)

    def table(self) -> ProblemTable:
        """The file in its shape; its values are not yet checked."""
        raw = read_toml(self._path, self._text, self._name, exact=True)
        if "groups" in raw:
            remedy = "write GROUPS = [group(name, about, draw), …] there: judge help problem-py"
            self.fault(("groups", 0), "test groups are declared in problem.py now", remedy)
        return self.shaped(raw, ProblemTable, ())

    def shaped(self, raw: Any, shape: type[T], path: KeyPath) -> T:
        """What stands at `path`, in that shape."""
        try:
            return msgspec.convert(raw, shape)
        except msgspec.ValidationError as why:
            from judge.problem.shape import refused  # most files are as they should be

            self._misshapen(refused(raw, shape, path, why))

    def _misshapen(self, found: Misfit) -> NoReturn:
        """Raise what is wrong, with the name that was meant."""
        from judge.problem.shape import Missing, NoChoice, Unknown, WrongKind

        path = found.path
        if isinstance(found, Unknown):
            self._unknown_key(found.key, path)
        if isinstance(found, Missing):
            self._missing_key(found.key, path, found.table)
        if isinstance(found, NoChoice):
            remedy = meant(found.given, found.choice, "use one of")
            self.fault(path, f"{path[-1]} = {found.given!r} is unknown", remedy)
        if isinstance(found, WrongKind):
            self.fault(path, f"{_dotted(path)} is {found.given}", f"give {found.wanted}")
        assert_never(found)

    def _unknown_key(self, key: str, path: KeyPath) -> NoReturn:
        known = fields_at(path)
        self.fault((*path, key), f"unknown key {key!r}", meant(key, known, "the keys are"))

    def _missing_key(self, key: str, path: KeyPath, table: dict[str, Any]) -> NoReturn:
        """A key that is missing is most often there, misspelt."""
        stray = nearest(key, set(table) - set(fields_at(path)))
        if stray is not None:
            self.fault((*path, stray), f"unknown key {stray!r}", f"did you mean {key!r}?")
        self.fault(path, f"the key {key!r} is missing in {_dotted(path)}", f"add {key} = …")


def group_place(problem: Problem, group: str) -> str:
    """Where a group is declared, as `id/problem.py:12`, for faults that only building shows."""
    return f"{problem.id}/problem.py:{next(each.line for each in problem.groups if each.name == group)}"


def key_place(problem: Problem, path: KeyPath) -> str:
    """Where a key stands, as `id/problem.toml:12`, for faults that the file alone does not show."""
    lines = key_lines(read_text(problem.folder / "problem.toml"))
    return f"{problem.id}/problem.toml:{line_of(path, lines)}"


def meant(name: str, names: Sequence[str], introduction: str = "there are") -> str:
    """What to do about a name that is none of `names`."""
    near = nearest(name, names)
    return f"did you mean {near!r}?" if near else f"{introduction} {', '.join(names) or 'none'}"


def _dotted(path: KeyPath) -> str:
    """A path for a person; the line says which of several tables it is in."""
    names = [str(part) for part in path if isinstance(part, str)]
    return ".".join(names) if names else "the file"
