"""What this machine has of a language: its tools, or the command that would install them.

Tools are asked where their parts lie; they are trusted, as whoever runs the judge trusts them.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple

from msgspec import Struct

from judge.cache import DISK, digest
from judge.errors import JudgeError
from judge.languages.model import Language

_PLACE = re.compile(r"\{(\w+)\}")
_PATIENCE = 60.0  # seconds for a tool's answer; Go looks through its whole library once
_COMMANDS = {
    "apt-get": "apt-get install",
    "dnf": "dnf install",
    "pacman": "pacman -S",
    "apk": "apk add",
    "zypper": "zypper install",
    "brew": "brew install",
}


class Toolchain(NamedTuple):
    """The tools of a language: what `{…}` in its commands stands for, and a key that changes with them.

    `files` are what its tools have prepared for the compiler, by name.
    """

    language: Language
    values: Mapping[str, str]
    key: str
    files: tuple[tuple[str, bytes], ...] = ()

    def filled(self, words: Iterable[str]) -> tuple[str, ...]:
        """The words with the tools in place; the sandbox's own places stay."""
        return tuple(_PLACE.sub(lambda match: self.values.get(match[1], match[0]), word) for word in words)


def missing(language: Language) -> list[str]:
    """The names of the tools that are not installed; none where all are."""
    return [names[0] for names in language.tools.values() if _first(names) is None]


def remedy(language: Language) -> str:
    """The command that installs the language here."""
    for manager, words in _COMMANDS.items():
        if manager in language.install and shutil.which(manager):
            return f"{words} {language.install[manager]}"
    return "install " + " and ".join(names[0] for names in language.tools.values())


def why_not(language: Language) -> str:
    """Why nothing in it can be run here: `no g++ (apt-get install g++)`; "" where its tools answer."""
    lacking = missing(language)
    if lacking:
        return f"no {' and '.join(lacking)} ({remedy(language)})"
    try:
        toolchain(language)
    except JudgeError as fault:  # such as a chooser of versions that has none to choose
        return f"{fault.what} ({fault.remedy})"
    return ""


class Availability(Struct, frozen=True):
    """What this machine has of a language: its version, or what is missing and the command for that.

    `works` is None where it was not tried; where it fails, `why_not` says why and `remedy` what would help.
    """

    name: str
    version: str = ""
    missing: str = ""
    remedy: str = ""
    works: bool | None = None
    why_not: str = ""


def found(language: Language) -> Availability:
    """What this machine has of a language; not tried, but for its version."""
    lacking = missing(language)
    if lacking:
        return Availability(language.name, missing=" and ".join(lacking), remedy=remedy(language))
    try:
        return Availability(language.name, version(language))
    except JudgeError as fault:
        return Availability(language.name, works=False, why_not=fault.what, remedy=fault.remedy or "")


def version(language: Language) -> str:
    """The first line that its tool says of itself; "" where it says none."""
    said = _asked(language, toolchain(language).filled(language.version))
    return next((line.strip() for line in said.splitlines() if line.strip()), "")


@cache
def toolchain(language: Language) -> Toolchain:
    """Where the tools of a language are; what they answered is kept as long as they stay the same.

    Raises:
        JudgeError: one is not installed, or does not say what it is asked.
    """
    lacking = missing(language)
    if lacking:
        what = f"{language.name} needs {' and '.join(lacking)}, which is not installed"
        raise JudgeError(what, remedy=remedy(language))
    tools = {key: os.path.realpath(path) for key, names in language.tools.items() if (path := _first(names))}
    key = _key(language, tools)
    if not language.probes and not language.prepared:
        return Toolchain(language, _with_places(language, tools), key)
    store, name = DISK, f"languages/{language.id}"
    found = store.read(name, key, _Answers)
    if found is None or not found.holds():
        found = _Answers(_probed(language, tools), _prepared(language, tools))
        store.write(name, key, found)
    values = {**tools, **found.values}
    whole = digest("\n".join([key, *map(_dated, found.values.values()), *found.files.values()]).encode())
    files = tuple((name, text.encode()) for name, text in found.files.items())
    return Toolchain(language, _with_places(language, values), whole, files)


class _Answers(NamedTuple):
    """What a language's tools have said: its probes, and its prepared files by name."""

    values: dict[str, str]
    files: dict[str, str]

    def holds(self) -> bool:
        """Whether what they named is still there; a cache that they named may have been emptied."""
        named = [*self.values.values(), *(text.strip().rpartition("=")[2] for text in self.files.values())]
        return all(os.path.exists(path) for path in named)  # noqa: PTH110 - of many kinds


def _probed(language: Language, tools: Mapping[str, str]) -> dict[str, str]:
    commands = {key: [_filled(word, tools) for word in words] for key, words in language.probes.items()}
    return {key: os.path.realpath(_asked(language, words).strip()) for key, words in commands.items()}


def _prepared(language: Language, tools: Mapping[str, str]) -> dict[str, str]:
    commands = {key: [_filled(word, tools) for word in words] for key, words in language.prepared.items()}
    return {key: _asked(language, words) for key, words in commands.items()}


def _with_places(language: Language, values: Mapping[str, str]) -> dict[str, str]:
    """The values with the folders that follow from them."""
    found = dict(values)
    for key, tool in language.homes.items():
        found[key] = str(Path(found[tool]).parent.parent)
    for key, path in language.folders.items():
        found[key] = str(Path(os.path.realpath(_filled(path, found))).parent)
    return found


def _filled(word: str, values: Mapping[str, str]) -> str:
    return _PLACE.sub(lambda match: values.get(match[1], match[0]), word)


def _first(names: Iterable[str]) -> str | None:
    return next((path for name in names if (path := shutil.which(name))), None)


def _key(language: Language, tools: Mapping[str, str]) -> str:
    """A digest of the description and of the tools' real files."""
    return digest("\n".join([language.digest, *map(_dated, tools.values())]).encode())


def _dated(path: str) -> str:
    """A file or the programs of a folder as they are now: another version of them reads otherwise."""
    place = Path(path)
    for each in (place / "bin", place):
        if each.exists() and (each != place or not place.is_dir()):
            found = each.stat()
            return f"{path} {found.st_size} {found.st_mtime_ns}"
    return path


def _asked(language: Language, command: Iterable[str]) -> str:
    """What a tool answers. Raises JudgeError where it fails."""
    words = list(command)
    try:
        done = subprocess.run(
            words,
            capture_output=True,
            text=True,
            timeout=_PATIENCE,
            cwd="/",
            stdin=subprocess.DEVNULL,
            check=False,
        )
    except OSError as fault:
        reason = (fault.strerror or "it failed").lower()
        raise JudgeError(f"{words[0]} cannot be started ({reason})", remedy=remedy(language)) from None
    except subprocess.TimeoutExpired:
        what = f"{' '.join(words)} does not answer within {_PATIENCE:g} s"
        raise JudgeError(what, remedy=f"repair it, or {remedy(language)}") from None
    if done.returncode:
        said = (done.stderr or done.stdout).strip().splitlines()
        what = f"{' '.join(words)} fails" + (f": {said[0][:200]}" if said else "")
        raise JudgeError(what, remedy=f"repair it, or {remedy(language)}")
    return done.stdout
