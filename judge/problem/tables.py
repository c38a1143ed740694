"""A TOML file into structs; what is wrong with it is told by its line, and by the key that was meant.

msgspec converts the tables. What it refuses it says in words of its own, with the place in the file; a person
is told in ours.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

import msgspec
from msgspec import inspect

from judge.errors import ProblemError, nearest
from judge.problem.model import Problem
from judge.problem.text import read_text
from judge.problem.toml import read_toml

T = TypeVar("T")
KeyPath = tuple[str | int, ...]  # ("parameters", "cx", "low")

_REFUSED = re.compile(r"(?P<what>.*?)(?: - at `\$(?P<path>.*)`)?", re.DOTALL)
_STEP = re.compile(r"\.([^.\[]+)|\[(\d+)\]|\[(\.\.\.)\]")
_QUOTED = re.compile(r"`([^`]*)`")
_KINDS = {
    "bool": "true or false",
    "int": "a whole number",
    "float": "a number with a point",
    "decimal": "a number with a point",
    "str": "text",
    "array": "a list",
    "object": "a table",
    "datetime": "a date and time",
    "date": "a date",
    "time": "a time",
}
_SIGNS = {">=": "of at least", "<=": "of at most", ">": "above", "<": "below"}
_HEADER = re.compile(r"\s*(\[\[?)\s*([^\[\]]+?)\s*\]\]?\s*(#.*)?$")
_KEY = re.compile(
    r"\s*+((?:[A-Za-z0-9_-]++|\"[^\"]*+\"|'[^']*+')(?:\s*+\.\s*+(?:[A-Za-z0-9_-]++|\"[^\"]*+\"|'[^']*+'))*+)\s*+="
)
_PART = re.compile(r"[A-Za-z0-9_-]+|\"[^\"]*\"|'[^']*'")


class TomlFile:
    """One TOML file, for a person called after its folder: "quadratic/problem.toml".

    With `exact`, its numbers with a point are Decimals. Raises ProblemError where it is no TOML.
    """

    def __init__(self, path: Path, *, exact: bool = False) -> None:
        self._name = f"{path.parent.name}/{path.name}"
        self._text = read_text(path)
        self.raw = read_toml(path, self._text, self._name, exact=exact)

    def fault(self, what: str, remedy: str, *path: str | int) -> ProblemError:
        """The fault of what stands at `path`."""
        where = f"{self._name}:{line_of(path, key_lines(self._text))}"
        return ProblemError(what, where=where, remedy=remedy)

    def read(self, shape: type[T], hook: Callable[[type, Any], Any] | None = None) -> T:
        """The file in that shape. `hook` makes what msgspec does not know, as `msgspec.convert` asks it to.

        What the hook refuses is told as `refusal` put it.
        """
        try:
            return msgspec.convert(self.raw, shape, dec_hook=hook)
        except msgspec.ValidationError as why:
            found = _REFUSED.fullmatch(str(why))
            assert found is not None
            path = self._path(found["path"] or "", shape, hook, str(why))
            raise self._misshapen(found["what"], path, shape) from None

    def _path(self, text: str, shape: Any, hook: Any, why: str) -> KeyPath:
        """The keys and places of msgspec's path, which calls every key of a dict `[...]`."""
        path: list[str | int] = []
        for key, place, any_key in _STEP.findall(text):
            if any_key:
                path.append(self._culprit(tuple(path), shape, hook, why))
            else:
                path.append(key or int(place))
        return tuple(path)

    def _culprit(self, path: KeyPath, shape: Any, hook: Any, why: str) -> str:
        """The key of the table at `path` that alone is refused for that reason."""
        table = _at(self.raw, path)
        for key, value in table.items():
            try:
                msgspec.convert(_replaced(self.raw, path, {key: value}), shape, dec_hook=hook)
            except msgspec.ValidationError as other:
                if str(other) == why:
                    return str(key)
        raise AssertionError(why)

    def _misshapen(self, what: str, path: KeyPath, shape: Any) -> ProblemError:
        name = str(next((part for part in reversed(path) if isinstance(part, str)), "the file"))
        dotted = ".".join(part for part in path if isinstance(part, str)) or "the file"
        named = _QUOTED.findall(what)
        if what.startswith("Object contains unknown field"):
            remedy = meant(named[0], self._keys(path, shape), "the keys are")
            return self.fault(f"unknown key {named[0]!r}", remedy, *path, named[0])
        if what.startswith("Object missing required field"):
            stray = nearest(named[0], set(_at(self.raw, path)) - set(self._keys(path, shape)))
            if stray is not None:  # it is most often there, misspelt
                return self.fault(f"unknown key {stray!r}", f"did you mean {named[0]!r}?", *path, stray)
            return self.fault(f"the key {named[0]!r} is missing in {dotted}", f"add {named[0]} = …", *path)
        given = _at(self.raw, path)
        if what.startswith("Invalid enum value"):
            choice = self._keys(path, shape)
            return self.fault(
                f"{name} = {given!r} is unknown", meant(str(given), choice, "use one of"), *path
            )
        if what.startswith("Invalid value"):  # of the key that says which form a table has
            return self.fault(
                f"no {name} is called {given!r}", meant(str(given), self._kind(path, shape)), *path
            )
        if "\0" in what:
            said, _, remedy = what.partition("\0")
            return self.fault(said.replace("{key}", name), remedy, *path)
        kinds = [_KINDS[each] for each in named[0].split(" | ") if each in _KINDS]
        wanted = "a number" if len(kinds) > 1 or named[0] == "float" else kinds[0]
        if len(named) > 1:
            return self.fault(f"{dotted} is {_KINDS.get(named[1], named[1])}", f"give {wanted}", *path)
        sign, _, bound = what.rpartition("`")[2].strip().partition(" ")
        return self.fault(f"{dotted} is {given}", f"give {wanted} {_SIGNS[sign]} {float(bound):g}", *path)

    def _keys(self, path: KeyPath, shape: Any) -> tuple[str, ...]:
        """The keys of the table at `path`, or the words that may stand there."""
        kind = self._kind(path, shape)
        if isinstance(kind, inspect.EnumType):
            return tuple(member.value for member in kind.cls)
        return tuple(each.encode_name for each in kind.fields)

    def _kind(self, path: KeyPath, shape: Any) -> Any:
        """What msgspec knows of the type at `path`; of several forms of a table, that which it says."""
        kind: Any = inspect.type_info(shape)
        for place, part in enumerate((*path, None)):
            if isinstance(kind, inspect.UnionType):
                kinds = [each for each in kind.types if not isinstance(each, inspect.NoneType)]
                if part is not None and part == getattr(kinds[0], "tag_field", None):
                    return [each.tag for each in kinds if isinstance(each, inspect.StructType)]
                given = _at(self.raw, path[:place])
                said = given.get(getattr(kinds[0], "tag_field", None)) if isinstance(given, dict) else None
                kind = next((each for each in kinds if said and getattr(each, "tag", "") == said), kinds[0])
            if part is None:
                break
            if isinstance(kind, inspect.StructType):
                kind = next(each.type for each in kind.fields if each.encode_name == part)
            else:
                kind = getattr(kind, "value_type", None) or kind.item_type
        return kind


def refusal(what: str, remedy: str) -> ValueError:
    """What a hook raises; {key} in `what` stands for the key."""
    return ValueError(f"{what}\0{remedy}")


def meant(name: str, names: Sequence[str], introduction: str = "there are") -> str:
    """What to do about a name that is none of `names`."""
    near = nearest(name, names)
    return f"did you mean {near!r}?" if near else f"{introduction} {', '.join(names) or 'none'}"


def _at(raw: Any, path: KeyPath) -> Any:
    for part in path:
        raw = raw[part]
    return raw


def _replaced(raw: Any, path: KeyPath, value: Any) -> Any:
    if not path:
        return value
    changed = raw.copy()
    changed[path[0]] = _replaced(raw[path[0]], path[1:], value)
    return changed


def key_place(problem: Problem, path: KeyPath) -> str:
    """Where a key stands, as `id/problem.toml:12`, for faults that the file alone does not show."""
    lines = key_lines(read_text(problem.folder / "problem.toml"))
    return f"{problem.id}/problem.toml:{line_of(path, lines)}"


# -- lines -------------------------------------------------------------------------------------------------


def key_lines(text: str) -> dict[KeyPath, int]:
    """The line, from 1, of every table header and key that stands at the start of a line.

    Keys inside inline tables and arrays are not listed: their own key is (see `line_of`).
    """
    lines: dict[KeyPath, int] = {(): 1}
    sizes: defaultdict[KeyPath, int] = defaultdict(int)  # of each array of tables so far
    table: KeyPath = ()
    inside: str | None = None  # the quotes of the multi-line string we are in
    for number, line in enumerate(text.splitlines(), start=1):
        if inside is None:
            if header := _HEADER.match(line):
                table = _enter(_parts(header[2]), header[1] == "[[", sizes)
                lines.setdefault(table, number)
            elif key := _KEY.match(line):
                lines.setdefault(table + _parts(key[1]), number)
        for quotes in re.findall(r"\"\"\"|'''", line):
            inside = quotes if inside is None else None if inside == quotes else inside
    return lines


def line_of(path: KeyPath, lines: dict[KeyPath, int]) -> int:
    """The line of `path`, or of the nearest thing around it that has one."""
    while path not in lines:
        path = path[:-1]
    return lines[path]


def _parts(dotted: str) -> KeyPath:
    return tuple(part.strip("\"'") for part in _PART.findall(dotted))


def _enter(names: KeyPath, is_array: bool, sizes: defaultdict[KeyPath, int]) -> KeyPath:
    """The full path of a table header; a name that is an array of tables stands for its last element."""
    path: KeyPath = ()
    for depth, name in enumerate(names, start=1):
        path += (name,)
        if is_array and depth == len(names):
            sizes[path] += 1
        if sizes[path]:
            path += (sizes[path] - 1,)
    return path
