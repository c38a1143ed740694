"""The YAML files of a package, which nobody trusts: small, plain, and without chains of aliases."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from judge.errors import ProblemError, UsageError
from judge.packs.foreign.opening import Opened

_LARGEST = 64 << 10  # bytes; the parser is slow
_MOST_BYTES = 1 << 20  # of all such files of a package
_MOST_ALIASES = 20  # a name stands for what it names, so that twenty of them cannot make much of little
_MOST_MERGES = 2  # of such names into other keys, each of which copies
_DEEPEST = 50  # things within things
_MOST_DIGITS = 400  # of a number: one with more is no float, and takes long to read
_INSTALL = "pip install 'circle-line-judge[kattis]', or pip install pyyaml"

Settings = dict[str, Any]


def read_settings(package: Opened, path: Path) -> Settings:
    """What a YAML file says, by key; nothing where it is empty.

    Raises:
        UsageError: PyYAML is not installed.
        ProblemError: it cannot be read, is no such YAML, or holds no keys.
    """
    where = package.name_of(path)
    try:
        import yaml  # an extra, and slow
    except ImportError:
        what = "packages of other judges are described in YAML, for which PyYAML is needed"
        raise UsageError(what, where=where, remedy=_INSTALL) from None
    content = package.read(path, _LARGEST)
    package.described += len(content)
    if package.described > _MOST_BYTES:
        what = f"the package's YAML files come to more than {_MOST_BYTES >> 20} MB with this one"
        raise ProblemError(what, where=where)
    loader = yaml.SafeLoader  # the one in C has no bound on how deeply things are nested
    try:
        too_much = _too_much(yaml.scan(content, Loader=loader))
        if too_much:
            raise ProblemError(f"this is no YAML: {too_much}", where=where)
        found = yaml.load(content, Loader=loader)
    except yaml.MarkedYAMLError as fault:
        place = fault.problem_mark
        line = f":{place.line + 1}" if place else ""
        raise ProblemError(f"this is no YAML: {_said(fault)}", where=f"{where}{line}") from None
    except (LookupError, AttributeError) as fault:  # how PyYAML fails on `!!int ""`, `!!bool x`
        raise ProblemError("this is no YAML: a value is none of what its tag says", where=where) from fault
    except (ValueError, OverflowError, TypeError):
        raise ProblemError("this is no YAML: a number or a date in it is none", where=where) from None
    except (yaml.YAMLError, RecursionError) as fault:
        deep = isinstance(fault, RecursionError)
        what = "it is nested too deeply" if deep else str(fault).partition("\n")[0]
        raise ProblemError(f"this is no YAML: {what[:200]}", where=where) from None
    if found is None:
        return {}
    if not isinstance(found, dict):
        raise ProblemError("it holds no keys with their values", where=where)
    return {str(key): value for key, value in found.items() if isinstance(key, str | int | float)}


def _said(fault: Any) -> str:
    """PyYAML's words, without signs of its own; some of its sentences begin in another place."""
    problem = fault.problem or "it is not well formed"
    whole = f"{fault.context}, {problem}" if problem.startswith("but ") and fault.context else problem
    return re.sub(r"'?<([a-z ]{1,30}+)>'?", r"the \1", whole)[:200]


def _too_much(tokens: Iterator[Any]) -> str:
    """What a file has too much of for its parser, found without reading to the end; empty for a sound one."""
    aliases = merges = depth = 0
    for token in tokens:
        kind = type(token).__name__
        depth += kind.endswith("StartToken") - kind.endswith("EndToken")
        aliases += kind == "AliasToken"
        merges += kind == "ScalarToken" and token.value == "<<"
        if depth > _DEEPEST:
            return "it is nested too deeply"
        if aliases > _MOST_ALIASES:
            return f"it holds more than {_MOST_ALIASES} aliases"
        if merges > _MOST_MERGES:
            return f"it merges keys with << more than {_MOST_MERGES} times"
        if kind == "ScalarToken" and _is_endless(token.value):
            return f"a number of more than {_MOST_DIGITS} digits"
    return ""


def _is_endless(word: str) -> bool:
    """Whether a word may be read as a number of very many digits."""
    return len(word) > _MOST_DIGITS and not word.strip("+-_.:0123456789abcdefABCDEFox")


def number(settings: Settings, key: str, usual: float, least: float, most: float, where: str) -> float:
    """The number under a key, the usual one where there is none. Raises ProblemError for anything else."""
    found = settings.get(key)
    if found is None:
        return usual
    sound = isinstance(found, int | float) and not isinstance(found, bool)
    if not sound or not least <= found <= most:  # nor is nan between them
        shown = repr(found[:40]) if isinstance(found, str) else str(found)[:40]
        what = f"{key} is {'no number' if isinstance(found, dict | list) else shown}"
        raise ProblemError(f"{what}: it must be from {least:,} to {most:,}", where=where)
    return float(found)


def section(settings: Settings, key: str, where: str) -> Settings:
    """The keys below a key. Raises ProblemError where something else is there."""
    found = settings.get(key)
    if found is None:
        return {}
    if not isinstance(found, dict):
        raise ProblemError(f"{key} holds no keys with their values", where=where)
    return found


def words(value: Any, key: str, where: str) -> tuple[str, ...]:
    """The words of a string, parted by spaces, or of a list of scalars. Raises ProblemError for more."""
    if isinstance(value, str):
        return tuple(value.split())
    if isinstance(value, int | float):
        return (str(value),)
    if isinstance(value, list) and all(isinstance(each, str | int | float) for each in value):
        return tuple(map(str, value))
    raise ProblemError(f"{key} is neither a line of words nor a list of them", where=where)
