"""A TOML file into structs; what is wrong with it is told by its line, and by the key that was meant."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from decimal import Decimal
from itertools import islice
from pathlib import Path
from typing import Any, TypeVar

import msgspec

from judge.errors import ProblemError, meant, nearest
from judge.files import read_ordinary_text
from judge.problem.model import FORMS, Problem

T = TypeVar("T")
KeyPath = Sequence[str | int]  # ("parameters", "cx", "low")

_ENDLESS = r"(?m)^(?:[^.\n]*+\.){100}"  # the parser copies each part of a dotted key
_REFUSED = r"(?s)(.*?)(?: - at `\$(.*)`)?"
_STEP = r"\.([^.\[]+)|\[(\d+)\]"
_EXPECTED = r"Expected `([^`]+?)(?: \| null)?`(?:, got `([^`]+)`)?(.*?)(?:\.0)?"
_KINDS = {
    "bool": "true or false",
    "int": "a whole number",
    "float": "a number",
    "int | float": "a number",
    "str": "text",
    "array": "a list",
    "object": "a table",
}
_TEXTS = r"(?s)\"\"\".*?\"\"\"|'''.*?'''"  # of several lines


def read_text(path: Path) -> str:
    """The text of one of a problem's files. Raises ProblemError."""
    try:
        text = read_ordinary_text(path)
        return text if path.suffix == ".toml" else text.removeprefix("\ufeff")
    except FileNotFoundError:
        what, remedy = "the file is missing", f"create {path}"
    except UnicodeDecodeError as error:
        what, remedy = f"byte {error.start} is not UTF-8", "save the file as UTF-8"
    except OSError as error:
        what, remedy = f"cannot be read: {error.strerror}", f"make {path} a readable file"
    raise ProblemError(what, where=f"{path.parent.name}/{path.name}", remedy=remedy)


def parse_toml(text: str, name: str, *, exact: bool = False) -> dict[str, Any]:
    """The tables of a text; for a person its file is called `name`.

    With `exact`, its numbers with a point or an exponent are Decimals. Raises ProblemError, with the line if
    it is known.
    """
    import tomllib  # not for who reads the cache

    where, remedy = name, "repair it"
    try:
        if endless := re.search(_ENDLESS, text):
            line_number = text.count("\n", 0, endless.end()) + 1
            raise tomllib.TOMLDecodeError(f"a key of more than 100 parts (at line {line_number})")
        return tomllib.loads(text, parse_float=Decimal if exact else float)
    except tomllib.TOMLDecodeError as error:
        what, _, at = str(error).partition(" (at ")
        found = re.match(r"line (\d+)", at)
        line = found[1] if found else text.count("\n") + 1
        what, where, remedy = what[:1].lower() + what[1:], f"{name}:{line}", "repair this line"
        if text.startswith("\ufeff"):
            what, remedy = "it begins with a byte order mark", "save it without a byte order mark"
    except ValueError:  # longer than Python reads
        what = "an integer has too many digits"
    except RecursionError:
        what = "its lists or tables are nested too deeply"
    raise ProblemError(f"not TOML: {what}", where=where, remedy=remedy)


class TomlFile:
    """One TOML file, for a person called after its folder: "quadratic/problem.toml".

    With `exact`, its numbers with a point are Decimals. Raises ProblemError where it is no TOML.
    """

    def __init__(self, path: Path, *, exact: bool = False) -> None:
        self._name = f"{path.parent.name}/{path.name}"
        self._text = read_text(path)
        self.raw = parse_toml(self._text, self._name, exact=exact)

    def place(self, path: KeyPath) -> str:
        """Where a key stands, or the nearest thing around it: `quadratic/problem.toml:12`."""
        return f"{self._name}:{line_of(self._text, path)}"

    def fault(self, what: str, remedy: str, *path: str | int) -> ProblemError:
        """The fault of what stands at `path`."""
        return ProblemError(what, where=self.place(path), remedy=remedy)

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


def key_place(problem: Problem, path: KeyPath) -> str:
    """Where a key of its problem.toml stands, for faults that the file alone does not show."""
    return TomlFile(problem.folder / "problem.toml").place(path)


def line_of(text: str, path: KeyPath) -> int:
    """The line, from 1, of the key or table at that path; else of the nearest thing around it."""
    text = re.sub(_TEXTS, lambda found: "\n" * found[0].count("\n"), text)
    at, key = 0, ""
    for part in path:
        nth, end = 0, r"[=.\]]"
        if isinstance(part, str):
            key = rf"""(?m)^[ \t]*+\[*+(?:[^=\n\]]*\.)?[ \t]*["']?{re.escape(part)}["']?[ \t]*"""
        else:
            nth, end = part, r"\]\]"
        found = next(islice(re.compile(key + end).finditer(text, at), nth, None), None)
        if found is None:
            break
        at = found.start()
    return text.count("\n", 0, at) + 1


# -- what msgspec refuses ----------------------------------------------------------------------------------


def told(why: msgspec.ValidationError, raw: Any, shape: Any) -> tuple[str, str, KeyPath]:
    """What is wrong with what msgspec refused to make that shape of, what to do about it, and where it is."""
    said, place = re.fullmatch(_REFUSED, str(why)).groups()  # type: ignore[union-attr]
    path = [key or int(number) for key, number in re.findall(_STEP, (place or "").replace("[...]", ""))]
    key = ".".join(part for part in path if isinstance(part, str)) or "the file"
    given = _at(raw, path)
    what, nul, remedy = said.partition("\0")
    if nul:
        return what.replace("{key}", key), remedy, path
    if expected := re.fullmatch(_EXPECTED, said):
        kind, got, bound = expected.groups()
        shown = repr(given) if isinstance(given, str) else given
        what = f"{key} is {_KINDS.get(got, f'a {got}')}" if got else f"{key} = {shown}"
        form = next((f"use {form}" for pattern, form in FORMS.items() if repr(pattern) in bound), None)
        return what, form or f"give {_KINDS.get(kind, kind)}{bound}", path
    from msgspec import inspect  # only for who mistyped something

    known = list(_known(inspect.type_info(shape), path, given))
    quoted = said.split("`")[1] if "`" in said else ""
    if said.startswith("Object contains unknown field"):
        return f"unknown key {quoted!r}", meant(quoted, known, "the keys are"), (*path, quoted)
    if said.startswith("Object missing required field"):
        stray = nearest(quoted, set(given) - set(known))
        if stray is not None:  # it is most often there, misspelt
            return f"unknown key {stray!r}", f"did you mean {quoted!r}?", (*path, stray)
        return f"the key {quoted!r} is missing in {key}", f"add {quoted} = …", path
    return f"{path[-1]} = {given!r} is unknown", meant(str(given), known, "use one of"), path


def refusal(what: str, remedy: str) -> ValueError:
    """What a hook raises; {key} in `what` stands for the key."""
    return ValueError(f"{what}\0{remedy}")


def _known(kind: Any, path: KeyPath, given: Any) -> Iterator[str]:
    """The keys of the table at `path`, which is `given`, or the words that may stand there.

    `kind` is what `msgspec.inspect` says of the whole.
    """
    for form in getattr(kind, "types", (kind,)):
        fields = {field.encode_name: field.type for field in getattr(form, "fields", ())}
        tag = getattr(form, "tag", None)
        match path:
            case [] if fields:
                yield from fields if tag is None or given.get(form.tag_field) == tag else ()
            case []:
                yield from (word.value for word in getattr(form, "cls", ()))
            case [int(), *inner]:
                yield from _known(getattr(form, "item_type", None), inner, given)
            case [name, *inner] if name in fields:
                yield from _known(fields[name], inner, given)
            case [_] if tag is not None:
                yield tag


def _at(raw: Any, path: KeyPath) -> Any:
    for part in path:
        raw = raw[part]
    return raw
