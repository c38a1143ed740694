"""A TOML file into structs; what is wrong with it is told by its line, and by the key that was meant."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Callable, Sequence
from decimal import Decimal
from pathlib import Path
from typing import Any, TypeVar

import msgspec

from judge.errors import ProblemError, nearest
from judge.files import read_ordinary_text
from judge.problem.model import Problem

T = TypeVar("T")
KeyPath = tuple[str | int, ...]  # ("parameters", "cx", "low")

_MOST_PARTS = 100  # of a dotted key, each of which the parser copies
_DOTTED = r"""(?:(?<![\w-])[\w-]++|"(?:[^"\\\n]|\\.){0,100}+"|'[^'\n]*+')[ \t]*+\.[ \t]*+"""
_ENDLESS = f"(?:{_DOTTED}){{{_MOST_PARTS}}}"
_REFUSED = r"(?s)(.*?)(?: - at `\$(.*)`)?"
_STEP = r"\.([^.\[]+)|\[(\d+)\]"
_EXPECTED = r"Expected `([^`]+)`(?:, got `([^`]+)`)?(.*)"
_KINDS = {
    "bool": "true or false",
    "int": "a whole number",
    "float": "a number",
    "int | float": "a number",
    "str": "text",
    "array": "a list",
    "object": "a table",
}
_HEADER = r"\s*(\[\[?)\s*([^\[\]]+?)\s*\]\]?\s*(#.*)?$"
_NAME = r"(?:[A-Za-z0-9_-]++|\"[^\"]*+\"|'[^']*+')"
_KEY = rf"\s*+({_NAME}(?:\s*+\.\s*+{_NAME})*+)\s*+="


def read_text(path: Path) -> str:
    """The text of one of a problem's files. Raises ProblemError."""
    where = f"{path.parent.name}/{path.name}"
    try:
        return read_ordinary_text(path)
    except FileNotFoundError:
        raise ProblemError("the file is missing", where=where, remedy=f"create {path}") from None
    except UnicodeDecodeError as error:
        what = f"byte {error.start} is not UTF-8"
        raise ProblemError(what, where=where, remedy="save the file as UTF-8") from None
    except OSError as error:
        what = f"cannot be read: {error.strerror}"
        raise ProblemError(what, where=where, remedy=f"make {path} a readable file") from None


def parse_toml(text: str, name: str, *, exact: bool = False) -> dict[str, Any]:
    """The tables of a text; for a person its file is called `name`.

    With `exact`, its numbers with a point or an exponent are Decimals. Raises ProblemError, with the line if
    it is known.
    """
    import tomllib  # not for who reads the cache

    line = None
    if text.count(".") >= _MOST_PARTS and (endless := re.search(_ENDLESS, text)):
        what, line = f"a key of more than {_MOST_PARTS} parts", text.count("\n", 0, endless.start()) + 1
    else:
        try:
            return tomllib.loads(text, parse_float=Decimal if exact else float)
        except tomllib.TOMLDecodeError as error:
            what, _, at = str(error).partition(" (at ")
            found = re.match(r"line (\d+)", at)
            what, line = what[:1].lower() + what[1:], int(found[1]) if found else text.count("\n") + 1
        except ValueError:  # longer than Python reads
            what = "an integer has too many digits"
        except RecursionError:
            what = "its lists or tables are nested too deeply"
    where, remedy = (f"{name}:{line}", "repair this line") if line else (name, "repair it")
    raise ProblemError(f"no TOML: {what}", where=where, remedy=remedy)


class TomlFile:
    """One TOML file, for a person called after its folder: "quadratic/problem.toml".

    With `exact`, its numbers with a point are Decimals. Raises ProblemError where it is no TOML.
    """

    def __init__(self, path: Path, *, exact: bool = False) -> None:
        self._name = f"{path.parent.name}/{path.name}"
        self._text = read_text(path)
        self.raw = parse_toml(self._text, self._name, exact=exact)

    def fault(self, what: str, remedy: str, *path: str | int) -> ProblemError:
        """The fault of what stands at `path`."""
        where = f"{self._name}:{line_of(path, key_lines(self._text))}"
        return ProblemError(what, where=where, remedy=remedy)

    def read(self, shape: type[T], hook: Callable[[type, Any], Any] | None = None, *path: str | int) -> T:
        """The table at `path`, the whole file without one, in that shape. Raises ProblemError.

        `hook` makes what msgspec does not know, as `msgspec.convert` asks it to; what it refuses is told as
        `refusal` put it.
        """
        raw = _at(self.raw, path)
        try:
            return msgspec.convert(raw, shape, dec_hook=hook)
        except msgspec.ValidationError as why:
            what, remedy, inside = told(why, raw, shape)
            raise self.fault(what, remedy, *path, *inside) from None


def told(why: msgspec.ValidationError, raw: Any, shape: Any) -> tuple[str, str, KeyPath]:
    """What is wrong with what msgspec refused to make that shape of, what to do about it, and where it is."""
    said, place = re.fullmatch(_REFUSED, str(why)).groups()  # type: ignore[union-attr]
    path = tuple(key or int(number) for key, number in re.findall(_STEP, place or ""))
    name = str(next((part for part in reversed(path) if isinstance(part, str)), "the file"))
    dotted = ".".join(part for part in path if isinstance(part, str)) or "the file"
    given = _at(raw, path)
    what, nul, remedy = said.partition("\0")
    if nul:
        return what.replace("{key}", name), remedy, path
    if expected := re.match(_EXPECTED, said):
        kind, got, bound = expected.groups()
        kind = kind.removesuffix(" | null")
        shown = repr(given) if isinstance(given, str) else given
        said = f"{dotted} is {_KINDS.get(got, f'a {got}')}" if got else f"{dotted} = {shown}"
        return said, f"give {_KINDS.get(kind, kind)}{bound.removesuffix('.0')}", path
    quoted = said.split("`")[1] if "`" in said else ""
    from msgspec import inspect  # only for who mistyped something

    known = _known(inspect.type_info(shape), path, given)
    if said.startswith("Object contains unknown field"):
        return f"unknown key {quoted!r}", meant(quoted, known, "the keys are"), (*path, quoted)
    if said.startswith("Object missing required field"):
        stray = nearest(quoted, set(given) - set(known))
        if stray is not None:  # it is most often there, misspelt
            return f"unknown key {stray!r}", f"did you mean {quoted!r}?", (*path, stray)
        return f"the key {quoted!r} is missing in {dotted}", f"add {quoted} = …", path
    return f"{name} = {given!r} is unknown", meant(str(given), known, "use one of"), path


def refusal(what: str, remedy: str) -> ValueError:
    """What a hook raises; {key} in `what` stands for the key."""
    return ValueError(f"{what}\0{remedy}")


def meant(name: str, names: Sequence[str], introduction: str = "there are") -> str:
    """What to do about a name that is none of `names`."""
    near = nearest(name, names)
    return f"did you mean {near!r}?" if near else f"{introduction} {', '.join(names) or 'none'}"


def _known(kind: Any, path: KeyPath, given: Any) -> list[str]:
    """The keys of the table at `path`, which is `given`, or the words that may stand there.

    `kind` is what `msgspec.inspect` says of the whole.
    """
    found: list[str] = []
    for form in getattr(kind, "types", (kind,)):
        fields = {field.encode_name: field.type for field in getattr(form, "fields", ())}
        tag_field, tag = getattr(form, "tag_field", None), getattr(form, "tag", None)
        if not path:
            found += [member.value for member in getattr(form, "cls", ())] if not fields else []
            found += fields if tag is None or given.get(tag_field) == tag else []
        elif tag is not None and path[0] == tag_field:
            found.append(tag)
        elif isinstance(path[0], int):
            found += _known(getattr(form, "item_type", None), path[1:], given)
        elif path[0] in fields:
            found += _known(fields[path[0]], path[1:], given)
    return list(dict.fromkeys(found))


def _at(raw: Any, path: KeyPath) -> Any:
    for part in path:
        raw = raw[part]
    return raw


# -- lines -------------------------------------------------------------------------------------------------


def key_place(problem: Problem, path: KeyPath) -> str:
    """Where a key stands, as `id/problem.toml:12`, for faults that the file alone does not show."""
    lines = key_lines(read_text(problem.folder / "problem.toml"))
    return f"{problem.id}/problem.toml:{line_of(path, lines)}"


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
            if header := re.match(_HEADER, line):
                table = ()
                names = _parts(header[2])
                for depth, name in enumerate(names, start=1):
                    table += (name,)
                    if header[1] == "[[" and depth == len(names):
                        sizes[table] += 1
                    if sizes[table]:  # the name of an array of tables stands for its last one
                        table += (sizes[table] - 1,)
                lines.setdefault(table, number)
            elif key := re.match(_KEY, line):
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
    return tuple(part.strip("\"'") for part in re.findall(_NAME, dotted))
