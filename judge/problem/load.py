"""A problem's folder - problem.toml, problem.py and statement.md - into one checked Problem, and its cache.

    problems/<place>          {"<id>": [stamp, key, its head], …}, one file for a folder of problems
    problems/<place>-<id>     the problem, whole

`stamp` is of the files' sizes and times: where it holds, none of them is read. Where it does not, the hash
`key` of what they and the judge's code hold says whether the problem is read anew: only then problem.py runs.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from decimal import Decimal
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Annotated, Any, TypeVar, cast

import msgspec
from msgspec import Meta, Struct
from msgspec.structs import replace

from judge.cache import DISK, code_files, code_key, content_key, digest, stamp
from judge.errors import ProblemError
from judge.problem.model import (
    FORMS,
    NAME,
    GroupLimits,
    Listed,
    Name,
    Parameter,
    Problem,
    PythonName,
    Source,
    Tier,
    TimeRule,
    is_name,
    tupled,
)
from judge.values.answers import Tolerance, Words
from judge.values.atoms import Type

P = TypeVar("P", bound=Listed)
_FORMAT = "3"  # raise it when the form of the file changes
_ROOMS = ("exact", "values", "problem", "data", "geometry")  # what groups and data depend on
_OWN = (".toml", ".md", ".py", "pins.json")
_MOST_DIGITS = 4_000  # of a number's exponent: Python reads and writes no integer above 4,300 digits


def load_problem(folder: Path, solutions: Path | None = None) -> Problem:
    """The problem of that folder; `solutions` is its own folder of solutions.

    By default that is `solutions/<id>` beside the folder of problems. A problem that was read before comes
    from the cache, and nothing of it is run. Raises ProblemError.
    """
    shelf = Shelf(folder.parent)
    problem = shelf.problem(folder, Problem)
    shelf.keep()
    return problem if solutions is None else replace(problem, solutions=solutions)


class Shelf:
    """The problems of one folder, from the cache as far as that holds. Call `keep` when all are asked for."""

    def __init__(self, root: Path) -> None:
        self._name = f"problems/{digest(os.fsencode(root))[:16]}"
        self._heads = DISK.read(self._name, _FORMAT, dict[str, tuple[str, str, Listed]]) or {}
        self._shared = [_code_stamp(), stamp(_files(root / "types", (".py",)))]
        self._changed = False

    def problem(self, folder: Path, kind: type[P]) -> P:
        """The problem of a folder in it, as much of it as `kind` has. Raises ProblemError."""
        name = folder.name
        if not is_name(name):
            what, remedy = f"{name!r} is no name for a problem", f"use {FORMS[NAME]}"
            raise ProblemError(what, where=str(folder), remedy=remedy)
        was, key, head = self._heads.get(name, ("", "", None))
        stamps = [*self._shared, stamp(_files(folder, _OWN))]
        now = "".join(stamps) if all(stamps) else ""
        found: Listed | None = None
        if (now and now == was) or problem_key(folder) == key:
            found = head if kind is Listed else self._decoded(folder, key)
        if found is None:
            key = problem_key(folder)
            found = whole = replace(_read(folder), key=key)
            if not key or problem_key(folder) != key:  # its files changed meanwhile
                return cast("P", replace(whole, key=""))
            head = msgspec.convert(whole, Listed, from_attributes=True)
            kept = msgspec.json.encode(replace(whole, folder=Path(), solutions=Path()), enc_hook=_encoded)
            DISK.write(f"{self._name}-{name}", key, kept)
            was = "nothing sound"
        if head and now != was:
            self._heads[name] = now, key, head
            self._changed = True
        return cast("P", found)

    def _decoded(self, folder: Path, key: str) -> Problem | None:
        """The whole problem that was kept, in its folder; None where there is none."""

        def made(wanted: Any, value: Any) -> Any:
            if wanted is Fraction:
                return _fraction(value)
            if wanted is Path:
                return folder
            return _type(value["type"], folder.parent / "types", Words(**value["words"]))

        plain = DISK.read(f"{self._name}-{folder.name}", key, bytes)
        try:
            problem = msgspec.json.decode(plain or b"", type=Problem, dec_hook=made)
        except (ValueError, TypeError, KeyError):  # msgspec's and TypeFault are ValueErrors
            return None
        from judge.values.parameters import listed

        examples = tuple(
            replace(each, case=tupled(each.case), wanted=listed(problem.answer, tupled(each.wanted)))
            for each in problem.examples
        )
        return replace(problem, solutions=_solutions(folder), examples=examples)

    def keep(self) -> None:
        """Write what changed to the cache."""
        if self._changed:
            DISK.write(self._name, _FORMAT, msgspec.json.encode(self._heads))


def own_files(folder: Path) -> list[str]:
    """The files of a problem's folder that it and its data are made from, and the pack's own types."""
    return [*_files(folder, _OWN), *_files(folder.parent / "types", (".py",))]


def _files(folder: Path, ends: tuple[str, ...]) -> list[str]:
    try:
        names = sorted(os.listdir(folder))  # noqa: PTH208 - of hundreds
    except OSError:
        return []
    return [f"{folder}/{name}" for name in names if name.endswith(ends)]


def problem_key(folder: Path) -> str:
    """The hash of all that the problem and its data are made from; "" where that cannot be read."""
    try:
        return digest(content_key(own_files(folder)).encode(), code_key(*_ROOMS).encode())[:32]
    except (OSError, ProblemError):  # whoever reads it says what is wrong
        return ""


@cache
def _code_stamp() -> str:
    return stamp(code_files(*_ROOMS))


_fraction = cache(Fraction)  # a problem has hundreds of them, most of them alike


@cache
def _type(text: str, folder: Path, words: Words = Words()) -> Type:  # noqa: B008 - frozen
    from judge.values.grammar import parse  # not for who lists problems

    return parse(text, folder if folder.is_dir() else None, words)


def _encoded(value: Any) -> Any:
    if isinstance(value, Type):
        return {"type": value.text, "words": msgspec.to_builtins(value.words)}
    return str(value)  # a Fraction or a path


def _solutions(folder: Path) -> Path:
    return folder.parent.parent / "solutions" / folder.name


# -- from the files ----------------------------------------------------------------------------------------


class Head(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A problem.toml, whole."""

    title: str
    tier: Tier
    summary: str
    entry: PythonName
    answer: Type
    parameters: dict[str, Any]  # a Parameter without its name each, in the order of the call
    tolerance: Tolerance | None = None
    limits: GroupLimits = GroupLimits()
    time: TimeRule | None = None
    growth: Annotated[float, Meta(gt=0, le=3)] | None = None  # an exponent's excess over the reference's
    words: Words = Words()
    sets: tuple[Name, ...] = ()
    place: int = 1_000_000
    source: Source = Source()


def _read(folder: Path) -> Problem:
    from judge.problem.module import with_groups  # none of these for who reads the cache
    from judge.problem.texts import read_statement
    from judge.problem.toml import TomlFile

    file, types = TomlFile(folder / "problem.toml", exact=True), folder.parent / "types"
    if "groups" in file.raw:
        remedy = "write GROUPS = [group(name, about, draw), …] there: judge help problem"
        raise file.fault("test groups are declared in problem.py now", remedy, "groups", 0)

    def hook(wanted: Any, value: Any) -> Any:
        return exact(wanted, value, types)

    head = file.read(Head, hook)
    parameters = []
    for name, row in head.parameters.items():
        if isinstance(row, dict):
            row["name"] = name
        each = file.read(Parameter, hook, "parameters", name)
        parameters.append(each if each.type.measured else replace(each, smallest=Fraction(0)))
    for what, remedy, *path in _faults(head, parameters):
        raise file.fault(what, remedy, *path)
    shared = {key: getattr(head, key) for key in Problem.__struct_fields__ if hasattr(head, key)}
    shared |= {"answer": _type(head.answer.text, types, head.words), "parameters": tuple(parameters)}
    where: dict[str, Any] = {"id": folder.name, "folder": folder, "solutions": _solutions(folder)}
    problem = Problem(**shared, **where, groups=(), slope=head.growth)
    statement, examples = read_statement(problem, file.raw)
    problem = replace(problem, statement=statement, examples=examples)
    return with_groups(problem, head.tolerance if head.answer.measured else Tolerance())


def exact(wanted: Any, value: Any, types: Path) -> Any:
    """A Fraction or a Type of what a setter writes, for `msgspec.convert`; a pack's types are in `types`."""
    from judge.problem.toml import refusal
    from judge.values.grammar import TypeFault

    if wanted is Type:
        if not isinstance(value, str):
            raise refusal("{key} is not text", 'give a type in quotes, such as "integer"')
        try:
            return _type(value, types)
        except TypeFault as fault:
            raise refusal(f"{{key}} = {fault.what}", fault.remedy) from None
    if isinstance(value, bool) or not isinstance(value, int | float | Decimal | Fraction):
        raise refusal("{key} is not a number", "give a number")
    number = Decimal(str(value)) if isinstance(value, float) else value
    if isinstance(number, Decimal) and not number.is_finite():
        raise refusal(f"{{key}} is {number}", "give a finite number")
    if isinstance(number, Decimal) and abs(number.adjusted()) > _MOST_DIGITS:
        raise refusal("{key} is absurdly large or small", f"stay within 1e±{_MOST_DIGITS}")
    return Fraction(number)


def _faults(head: Head, parameters: Sequence[Parameter]) -> Iterator[Sequence[str]]:
    """What the shape alone does not say: what is wrong, what to do about it, and the keys of the place."""
    from judge.languages import described, is_described  # not for who lists problems
    from judge.problem.toml import meant
    from judge.values.types import ArrayType, lasting

    if isinstance(lasting(head.answer), ArrayType):
        what = f"no answer can be of the type {head.answer}"
        yield what, "an array is a parameter's; write a list, which may be one too", "answer"
    if head.growth is not None and head.time is None:
        what = "growth is measured beside a reference solution, and there is none"
        yield what, "add a [time] table that names one", "growth"
    for at, name in enumerate(head.sets):
        if name in head.sets[:at]:
            yield f"{name!r} is there twice in sets", "remove one", "sets"
    if head.tolerance is not None and (fault := tolerance_fault(head.tolerance, head.answer)):
        yield fault
    for language in head.time.references if head.time else ():
        if not is_described(language):
            what = f"there is no language {language!r}"
            yield what, meant(language, described()), "time", "references", language
    for each in parameters:
        path = "parameters", each.name
        if each.low > each.high:
            yield f"the bounds of {each.name!r} leave nothing: low is above high", "swap them", *path, "low"
        if not each.type.is_parameter:
            what = f"no parameter can be of the type {each.type}"
            yield what, "an array is a whole parameter", *path, "type"
        if not 0 <= each.smallest <= 1:
            what = f"the smallest number of {each.name!r} other than 0 is not from 0 to 1"
            yield what, "an int other than 0 is never smaller than 1", *path, "smallest"


def tolerance_fault(tolerance: Tolerance, answer: Type) -> Sequence[str] | None:
    """What is wrong with a tolerance for such answers, what to do about it, and the keys; None if nothing."""
    if not answer.measured:
        what = "an answer without real numbers is right or wrong and has no tolerance"
        return what, "remove it", "tolerance"
    for key in tolerance.__struct_fields__:
        if getattr(tolerance, key) < 0:
            return f"the tolerance {key} is negative", "give 0 or more", "tolerance", key
    if not (tolerance.extent or tolerance.relative or tolerance.ulps):
        what = "the tolerance is 0, which no double can meet"
        return what, "give relative, extent or ulps", "tolerance"
    return None
