"""What a language is: one TOML file of this folder, read once, and checked as it is read.

A word of a command line may hold `{…}`: a tool or a folder that `judge.languages.find` finds on this machine,
or one of the places that the sandbox fills in when it knows them.

    {source} {sources} {folder}      what a compiler reads: the first file, all of them, their folder
    {out} {scratch}                  where its result goes, what else it may fill
    {box} {main} {class} {memory}    of a program: its folder, the file it starts with, the limit in MB
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Annotated, Literal

import msgspec
from msgspec import Meta, Struct

from judge.cache import digest
from judge.errors import JudgeError, UsageError, nearest
from judge.languages import FILE, NAME, SUFFIX, VARIABLE, folders
from judge.languages.scan import MARK, PARAMETERS, Tokens, beginning, usual_tokens

_Words = tuple[str, ...]
_Name = Annotated[str, Meta(min_length=1)]
_Over = Literal["parameters", "structs", "lacking", "fields", "parts", "big", "dicts", "methods", "members"]


class Compiling(Struct, frozen=True, forbid_unknown_fields=True):
    """How a source is compiled: the command lines, what they may read and what they may start as well.

    `keeps` says that nothing is made: what is run is the source itself. `complaint` is a pattern of what a
    compiler says of a fault, with groups `message`, `file`, `line` and perhaps `column`; without it the usual
    forms are known, such as `file:line:column: error: message`. `warning` is one of what it says of a source
    that it compiles, and that may well be why an answer is wrong. With one of `checks`, the first
    that this machine has all for, at the end of each command line it makes a program that tells of its own
    faults; a file checks.* of the language's folder is there as well. Each of `finds` is a pattern of that,
    with groups `message` and perhaps `line` and `of`, what the message is about.
    """

    steps: tuple[_Words, ...]
    reads: _Words = ()
    runs: _Words = ()
    environment: dict[str, str] = {}
    keeps: bool = False
    complaint: str = ""
    warning: str = ""
    checks: tuple[_Words, ...] = ()
    finds: _Words = ()


class Running(Struct, frozen=True, forbid_unknown_fields=True):
    """How what was made is run.

    `stack` is in MB, 0 for as much as the memory limit; `allowance` are the MB of address space for data that
    the runtime takes on top of the limit; `out_of_memory` is what it says when it finds none. `packages` are
    the name of a folder that `$JUDGE_PACKAGES` may name, and the variable that tells the runtime of it.
    """

    command: _Words
    reads: _Words = ()
    runs: _Words = ()
    environment: dict[str, str] = {}
    stack: int = 0
    allowance: int = 0
    out_of_memory: str = ""
    packages: _Words = ()


class Language(
    Struct, frozen=True, forbid_unknown_fields=True, rename={"compiling": "compile", "running": "run"}
):
    """One language.

    `spelling` is how names of several words are written in it, `file` what a submission's own file is called
    where it is compiled, `main` a pattern that is met where a source is a whole program, `defines` one that
    is met where it defines the function `{entry}` of `{parameters}`, in their brackets, and `classes` one
    where it defines the class `{entry}`: without it no class is called. `unsaid` is what begins and ends its
    comments and strings, see `judge.languages.scan.Tokens`; without it they are those of C, or of Python
    where `comment` is not `//`. Outside of those `drops` is a pattern of what is taken out before it is
    compiled, and `swaps` are pairs of one and what stands for it then. No pattern may try a text in many
    ways: write a*+ for a*, a++ for a+, (?>(?:ab){0,9}) for (?:ab)*. `empty` is a program that does nothing,
    as costly as any program before its first line. `tools` are the names that each tool may have; `homes`
    the folder above the folder of a tool's real file, `folders` where a file really lies, `probes` a tool's
    answer that is a path, `prepared` one that is kept as a file for the compiler. `spell` are the rules by
    which functions are written, see `judge.languages.spell`.
    """

    name: _Name
    suffixes: Annotated[tuple[Annotated[str, Meta(pattern=r"^(\.\w+)+$")], ...], Meta(min_length=1)]
    order: int
    spelling: Annotated[str, Meta(pattern="^(snake|camel)$")]
    file: _Name
    main: str
    empty: str
    tools: Annotated[dict[str, tuple[_Name, ...]], Meta(min_length=1)]
    install: dict[str, str]
    version: _Words
    compiling: Compiling
    running: Running
    drops: str = ""
    swaps: tuple[tuple[str, str], ...] = ()
    unsaid: tuple[Annotated[_Words, Meta(min_length=1, max_length=3)], ...] = ()
    defines: str = ""
    classes: str = ""
    comment: str = "//"  # what begins one
    factor: Annotated[float, Meta(ge=1)] = 1.0  # how many times Python's time short work may well take in it
    homes: dict[str, str] = {}
    folders: dict[str, str] = {}
    probes: dict[str, _Words] = {}
    prepared: dict[str, _Words] = {}
    spell: dict[str, str | dict[str, str] | tuple[_Over, str, str]] = {}
    id: str = ""
    folder: str = ""
    digest: str = ""

    def __hash__(self) -> int:
        return hash(self.digest)

    @property
    def is_ours(self) -> bool:
        """Whether the judge itself describes it."""
        return Path(self.folder).parent == folders()[0]

    @property
    def tokens(self) -> Tokens:
        """What begins and ends its comments and strings."""
        return self.unsaid or usual_tokens(self.comment)

    def patterns(self) -> Iterator[tuple[str, str]]:
        """All its patterns, each with the key that it has in the description."""
        yield "main", self.main
        yield "defines", self.head("f")
        yield "classes", self.head("F", is_class=True)
        yield "complaint", self.compiling.complaint
        yield "warning", self.compiling.warning
        yield from (("finds", pattern) for pattern in self.compiling.finds)
        yield "drops", self.drops
        yield from (("swaps", pattern) for pattern, _ in self.swaps)
        yield from (("unsaid", part) for each in self.unsaid for part in each if MARK not in part)
        yield "unsaid", beginning(self.tokens)  # whose groups may be there twice

    def head(self, entry: str, *, is_class: bool = False) -> str:
        """The pattern of where it defines what the problem calls so; empty without one."""
        name = re.escape(self.spelt(entry))
        pattern = self.classes if is_class else self.defines
        return pattern.replace("{entry}", name).replace("{parameters}", PARAMETERS)

    def spelt(self, name: str) -> str:
        """A name of several words, such as `signed_area`, as the language writes it."""
        first, *rest = name.split("_")
        return name if self.spelling == "snake" else first + "".join(word.capitalize() for word in rest)


@cache
def languages() -> tuple[Language, ...]:
    """The judge's own languages and those of `$JUDGE_LANGUAGES`; of two with one id the later counts.

    Raises JudgeError for a broken description.
    """
    found = {language.id: language for folder in folders() for language in _read_all(folder)}
    return tuple(sorted(found.values(), key=lambda each: (each.order, each.id)))


def language_of_file(name: str) -> Language | None:
    """The language whose suffix ends that name."""
    return next((each for each in languages() if name.endswith(each.suffixes)), None)


def language_called(name: str) -> Language | None:
    """The language of that name or id, however it is capitalised; also by its suffix, with or without dot."""
    word = name.casefold()
    for each in languages():
        if word in (each.id, each.name.casefold()) or f".{word.lstrip('.')}" in each.suffixes:
            return each
    return None


def named_language(name: str) -> Language | None:
    """As `language_called`; None for Python. Raises UsageError for a name that nobody knows."""
    if name.casefold() in (NAME.casefold(), SUFFIX, SUFFIX.lstrip(".")):
        return None
    found = language_called(name)
    if found is None:
        ids = [NAME.lower(), *(each.id for each in languages())]
        meant = nearest(name.casefold(), ids)
        remedy = f"did you mean {meant}?" if meant else f"languages are {', '.join(ids)}"
        raise UsageError(f"there is no language {name}", remedy=remedy)
    return found


def _read_all(folder: Path) -> list[Language]:
    paths = sorted(folder.glob(f"*/{FILE}"))
    if not paths:
        remedy = f"correct ${VARIABLE}"
        raise JudgeError("no language is described here", where=str(folder), remedy=remedy)
    return [_read(path) for path in paths]


def _read(path: Path) -> Language:
    import tomllib  # only where another language than Python is named

    try:
        content = path.read_bytes()
        table = tomllib.loads(content.decode())
        place = {"id": path.parent.name, "folder": str(path.parent), "digest": digest(content)}
        found = msgspec.convert({**table, **place}, Language)
        _check_patterns(found)
    except OSError as fault:
        raise JudgeError(
            f"cannot be read: {fault.strerror}", where=str(path), remedy="make it readable"
        ) from None
    except (ValueError, msgspec.ValidationError) as fault:
        raise JudgeError(f"it describes no language: {fault}", where=str(path), remedy="correct it") from None
    return found


def _check_patterns(language: Language) -> None:
    """Raises ValueError for what is no pattern, and for a complaint's without what it must tell."""
    for key, pattern in language.patterns():
        try:
            groups = re.compile(pattern).groupindex
        except re.error as fault:
            raise ValueError(f"{key} is not a pattern: {fault}") from None
        told = key in ("complaint", "warning") and pattern
        if told and not {"message", "file", "line"} <= set(groups):
            raise ValueError(f"{key} needs the groups message, file and line")
