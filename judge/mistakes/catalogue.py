"""What is said of each mistake: solutions/mistakes.toml, one file for all problems of a pack.

[floor-division]
seen = "The answers snap to whole numbers."  # in the answers, without a sign of code
example = "`//` drops everything behind the point"  # what the code may do, told after "For example,"
advice = "Divide with `/`."
state = true               # it is one only if a case passes when it is called alone
form = true                # the answer's form is wrong, and that is the mistake itself
needs = ["//", "whole"]    # a program has one of these, or does not make it (judge.repair.features)
edits = { "b = 2 * b" = "…" }  # lines that make it before the call of a right way, or after it where they
                           # assign `answer`, in each problem with these parameters; what is said of each

[floor-division.in.middle] # in one problem other words, or other of the keys above
seen = "…"

[kind.room]                # what is said of a repair of that kind (judge.repair); {which} is what coincides
seen = "…"                 # in place of the words of seen.toml
names = ["…"]              # the mistakes that it may be, the likeliest first
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

import msgspec
from msgspec import Struct

from judge.cache import DISK, digest
from judge.errors import ProblemError, meant
from judge.problem import Problem
from judge.problem.solutions import SolutionKind, read_solutions, usual_first
from judge.problem.toml import parse_toml, read_text
from judge.repair.features import FEATURES

FILE = "mistakes.toml"
_USUAL = "usual.toml"
EXAMPLE = "For example,"  # what begins so speaks of code, and may be otherwise in a program
_KIND = "kind"  # the table of what is said of repairs


class MistakeText(Struct, frozen=True):
    """One mistake: what is seen in the answers, an example in code, what to do instead, and how it shows."""

    seen: str = ""
    example: str = ""
    advice: str = ""
    state: bool = False
    form: bool = False
    needs: tuple[str, ...] = ()
    edits: Mapping[str, str] = {}

    @property
    def told(self) -> str:
        """All texts in one."""
        example = f"{EXAMPLE} {self.example}." if self.example else ""
        return " ".join(filter(None, (self.seen, example, self.advice)))


class KindWords(Struct, frozen=True):
    """What is said of a kind of repair, and the names that it may have."""

    seen: str = ""
    names: tuple[str, ...] = ()


Catalogue = Mapping[str, MistakeText]
Kinds = Mapping[str, KindWords]


def read_catalogue(problem: Problem) -> Catalogue:
    """Every mistake's words in this problem, those of no topic too. Raises ProblemError."""
    return {**_usual(), **_read(problem)[0]}


def read_kinds(problem: Problem) -> Kinds:
    """What is said of each kind of repair; nothing where the pack has no such file. Raises ProblemError."""
    return _read(problem)[1]


@cache
def _usual() -> Catalogue:
    """The words that the judge has for any kata."""
    tables = parse_toml(read_text(Path(__file__).with_name(_USUAL)), _USUAL)
    return msgspec.convert(tables, dict[str, MistakeText])


def _read(problem: Problem) -> tuple[Catalogue, Kinds]:
    path = problem.solutions.parent / FILE
    if not path.is_file():
        return {}, {}
    where = f"{path.parent.name}/{FILE}"
    text = read_text(path)
    store, place = DISK, (f"mistakes/words-{digest(os.fsencode(path))[:8]}", text)
    tables = store.read(*place, dict[str, Any])
    known = tables is not None
    if tables is None:
        tables = parse_toml(text, where)
    try:
        told = msgspec.convert(tables.get(_KIND, {}), dict[str, KindWords])
    except msgspec.ValidationError as fault:
        remedy = "seen is a text, names is a list"
        raise ProblemError(f"in [{_KIND}]: {fault}", where=where, remedy=remedy) from None
    names = [name for name in tables if name != _KIND]
    found = {name: _words(name, tables[name], problem.id, where) for name in names}
    if not known:
        with suppress(TypeError):  # a date in the words for another problem
            store.write(*place, tables)
    return found, told


def _words(name: str, table: Any, problem: str, where: str) -> MistakeText:
    if not isinstance(table, dict):
        remedy = f"begin a table: [{name}]"
        raise ProblemError(f"{name} is not a table", where=where, remedy=remedy)
    own = table.get("in", {})
    special = own.get(problem, {}) if isinstance(own, dict) else None
    if not isinstance(special, dict):
        remedy = f"write [{name}.in.{problem}]"
        raise ProblemError(f"{name}.in is not a table of katas", where=where, remedy=remedy)
    other = {"example": ""} if "seen" in special else {}  # the example is one of what is seen
    merged = {**table, **other, **special}
    merged.pop("in", None)
    unknown = set(merged) - set(MistakeText.__struct_fields__)
    if unknown:
        key = min(unknown)
        remedy = meant(key, MistakeText.__struct_fields__, "the keys are")
        raise ProblemError(f"unknown key {key!r} in [{name}]", where=where, remedy=remedy)
    try:
        words = msgspec.convert(merged, MistakeText)
    except msgspec.ValidationError as why:
        remedy = "the first three keys are texts, needs is a list, edits a table, the others true or false"
        raise ProblemError(f"in [{name}]: {why}", where=where, remedy=remedy) from None
    for feature in words.needs:
        if feature not in FEATURES:
            remedy = meant(feature, sorted(FEATURES), "it is one of")
            raise ProblemError(f"[{name}] needs {feature!r}, which nobody finds", where=where, remedy=remedy)
    return words


def told_mistakes(problem: Problem) -> Mapping[str, str]:
    """The first sentence of every mistake by its name, as mistakes.toml has it, or the program of wrong/.

    Nothing of the pack is run; a file that cannot be read is passed over: `judge verify` tells of it.
    """
    programs = usual_first(read_solutions(problem, SolutionKind.WRONG).programs)
    found = {each.name: each.sentence for each in reversed(programs)}
    with suppress(ProblemError):
        aimed = {name for group in problem.groups for name in group.kills}
        told = read_catalogue(problem).items()
        found |= {name: words.seen for name, words in told if name in aimed and words.told}
    return found
