"""The tables of a TOML file, parsed once: until its text changes they are read from the cache.

    <cache folder>/toml/<place>-<key>.json      the tables as JSON; {"": "1e-9"} is an exact number

`place` stands for the file's path, `key` for its text. Parsing a problem.toml takes as long as starting an
interpreter does.
"""

from __future__ import annotations

import os
import re
from contextlib import suppress
from decimal import Decimal
from pathlib import Path
from typing import TYPE_CHECKING, Any

from judge.digest import digest_of
from judge.errors import ProblemError
from judge.files import cache_folder
from judge.kept import KeptFile

if TYPE_CHECKING:
    import tomllib

_MOST_PARTS = 100  # of a dotted key, each of which the parser copies
_PART = r"""(?:(?<![\w-])[\w-]++|"(?:[^"\\\n]|\\.){0,100}+"|'[^'\n]*+')[ \t]*+\.[ \t]*+"""
_ENDLESS = f"(?:{_PART}){{{_MOST_PARTS}}}"
_EXACT = ""  # the only key of a table that stands for an exact number


class _Unfit(Exception):  # noqa: N818 - no error: such tables are parsed each time
    """The tables hold what JSON cannot: a date, an empty key."""


def read_toml(path: Path, text: str, name: str, *, exact: bool = False) -> dict[str, Any]:
    """The tables of the `text` that the file at `path` holds; for a person the file is called `name`.

    With `exact`, its numbers with a point or an exponent are Decimals. Raises ProblemError, with the line if
    it is known.
    """
    kept = _kept(path, text, exact)
    found = kept.read(dict[str, Any])
    if isinstance(found, dict):
        return _tables(found) if exact else found
    tables = toml_of(text, name, exact=exact)
    with suppress(_Unfit, ValueError, RecursionError):
        kept.write(_plain(tables))
    return tables


def _kept(path: Path, text: str, exact: bool) -> KeptFile:
    place = digest_of(os.fsencode(path))[:16]
    key = digest_of(f"{exact}/{text}".encode())[:32]
    return KeptFile(cache_folder, "toml", f"{place}-", key)


def _plain(value: Any) -> Any:
    """As JSON holds it. Raises _Unfit."""
    if isinstance(value, dict):
        if _EXACT in value:
            raise _Unfit
        return {key: _plain(each) for key, each in value.items()}
    if isinstance(value, list):
        return [_plain(each) for each in value]
    if isinstance(value, Decimal):
        return {_EXACT: str(value)}
    if isinstance(value, str | int | float):
        return value
    raise _Unfit


def _tables(value: Any) -> Any:
    """What `_plain` was given."""
    if isinstance(value, dict):
        if _EXACT in value:
            return Decimal(value[_EXACT])
        return {key: _tables(each) if type(each) in (dict, list) else each for key, each in value.items()}
    if isinstance(value, list):
        return [_tables(each) for each in value]
    return value


def toml_of(text: str, name: str, *, exact: bool = False) -> dict[str, Any]:
    """As `read_toml`, of a text that is in no file."""
    import tomllib  # seldom

    if endless := re.search(_ENDLESS, text):
        line = text.count("\n", 0, endless.start()) + 1
        what = f"no TOML: a key of more than {_MOST_PARTS} parts"
        raise ProblemError(what, where=f"{name}:{line}", remedy="repair this line")
    try:
        return tomllib.loads(text, parse_float=Decimal if exact else float)
    except tomllib.TOMLDecodeError as error:
        what = str(error).partition(" (at ")[0]
        line = _line_of(error, text)
        what, where = f"{what[:1].lower()}{what[1:]}", f"{name}:{line}"
    except ValueError:  # longer than Python reads
        what, where = "an integer has too many digits", name
    except RecursionError:
        what, where = "its lists or tables are nested too deeply", name
    raise ProblemError(
        f"no TOML: {what}", where=where, remedy="repair this line" if ":" in where else "repair it"
    )


def _line_of(error: tomllib.TOMLDecodeError, text: str) -> int:
    """The line of a fault; before Python 3.14 it is in the error's text alone: "… (at line 3, column 1)"."""
    line = getattr(error, "lineno", None)
    if isinstance(line, int):
        return line
    number = str(error).rpartition("(at line ")[2].partition(",")[0]
    return int(number) if number.isdecimal() else text.count("\n") + 1
