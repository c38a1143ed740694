"""A problem's folder - problem.toml, problem.py and statement.md - into one checked Problem, and its cache.

    problems/<place>          {"<id>": [stamp, key, its head], …}, one file for a folder of problems
    problems/<place>-<id>     the problem, whole

`stamp` is of the files' sizes and times: where it holds, none of them is read. Where it does not, the hash
`key` of what they and the judge's code hold says whether the problem is read anew: only then problem.py runs.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeVar, cast

import msgspec
from msgspec import Meta, Struct
from msgspec.structs import replace

from judge.cache import DISK, Store, code_files, code_key, content_key, digest, stamp
from judge.errors import ProblemError
from judge.problem.model import (
    GroupLimits,
    Listed,
    Parameter,
    Problem,
    Source,
    Tier,
    TimeRule,
    is_name,
    tupled,
)
from judge.values.answers import Tolerance, Words
from judge.values.atoms import Type

if TYPE_CHECKING:
    pass

P = TypeVar("P", bound=Listed)
_FORMAT = "2"  # raise it when the form of the file changes
_ROOMS = ("exact", "values", "problem", "data", "geometry")  # what groups and data depend on
_OWN = (".toml", ".md", ".py", "pins.json")
_MOST_DIGITS = 4_000  # of a number's exponent: Python reads and writes no integer above 4,300 digits
_PLAIN = "use a plain Python name"
_NAME = "use small letters, digits and single hyphens"


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

    def __init__(self, root: Path, store: Store = DISK) -> None:
        self._store = store
        self._name = f"problems/{digest(os.fsencode(root))[:16]}"
        self._heads = self._store.read(self._name, _FORMAT, dict[str, tuple[str, str, msgspec.Raw]]) or {}
        self._shared = [_code_stamp(), stamp(_files(root / "types", (".py",)))]
        self._changed = False

    def problem(self, folder: Path, kind: type[P]) -> P:
        """The problem of a folder in it, as much of it as `kind` has. Raises ProblemError."""
        name = folder.name
        if not is_name(name):
            raise ProblemError(f"{name!r} is no name for a problem", where=str(folder), remedy=_NAME)
        was, key, head = self._heads.get(name, ("", "", msgspec.Raw()))
        stamps = [*self._shared, stamp(_files(folder, _OWN))]
        now = "".join(stamps) if all(stamps) else ""
        problem = None
        if (now and now == was) or problem_key(folder) == key:
            body = head if kind is Listed else self._store.read(f"{self._name}-{name}", key, bytes)
            problem = _decoded(body or b"", folder, kind)
        if problem is None:
            key = problem_key(folder)
            whole = replace(_read(folder), key=key)
            problem = cast("P", whole)
            if not key or problem_key(folder) != key:  # its files changed meanwhile
                return replace(problem, key="")
            plain = msgspec.to_builtins(replace(whole, folder=Path(), solutions=Path()), enc_hook=_encoded)
            head = msgspec.Raw(msgspec.json.encode(msgspec.convert(plain, Listed)))
            self._store.write(f"{self._name}-{name}", key, msgspec.json.encode(plain))
            was = "nothing sound"
        if now != was:
            self._heads[name] = now, key, head
            self._changed = True
        return problem

    def keep(self) -> None:
        """Write what changed to the cache."""
        if self._changed:
            self._store.write(self._name, _FORMAT, msgspec.json.encode(self._heads))


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


def _decoded(plain: bytes | msgspec.Raw, folder: Path, kind: type[P]) -> P | None:
    """The problem that was kept, in its folder; None where it is none."""

    def made(wanted: Any, value: Any) -> Any:
        if wanted is Fraction:
            return _fraction(value)
        if wanted is Path:
            return folder
        return _type(value["type"], types, Words(**value["words"]))

    types = folder.parent / "types"
    try:
        problem = msgspec.json.decode(plain, type=kind, dec_hook=made)
    except (ValueError, TypeError, KeyError):  # msgspec's and TypeFault are ValueErrors
        return None
    if not isinstance(problem, Problem):
        return problem
    from judge.values.parameters import listed

    examples = tuple(
        replace(each, case=tupled(each.case), wanted=listed(problem.answer, tupled(each.wanted)))
        for each in problem.examples
    )
    return replace(problem, solutions=_solutions(folder), examples=examples)


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


class Row(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A row of `[parameters]`: `cx = { type = "number", about = "x of the centre" }`."""

    type: Type
    about: str
    low: Fraction = Fraction(-(2**30))
    high: Fraction = Fraction(2**30)
    smallest: Fraction | None = None  # 1e-30 for real numbers


class Head(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A problem.toml, whole."""

    title: str
    tier: Tier
    summary: str
    entry: str
    answer: Type
    parameters: dict[str, Any]  # a Row each, in the order of the call
    tolerance: Tolerance | None = None
    limits: GroupLimits = GroupLimits()
    time: TimeRule | None = None
    growth: Annotated[float, Meta(gt=0, le=3)] | None = None  # an exponent's excess over the reference's
    words: Words = Words()
    sets: tuple[str, ...] = ()
    place: int | None = None
    source: Source = Source()


def _read(folder: Path) -> Problem:
    from judge.problem.module import with_groups  # none of these for who reads the cache
    from judge.problem.texts import read_statement
    from judge.problem.toml import TomlFile

    file = TomlFile(folder / "problem.toml", exact=True)
    if "groups" in file.raw:
        remedy = "write GROUPS = [group(name, about, draw), …] there: judge help problem"
        raise file.fault("test groups are declared in problem.py now", remedy, "groups", 0)

    def hook(wanted: Any, value: Any) -> Any:
        return made(wanted, value, folder.parent / "types")

    head = file.read(Head, hook)
    for what, remedy, *path in _faults(head, file.raw):
        raise file.fault(what, remedy, *path)
    parameters = []
    for name in head.parameters:
        row = file.read(Row, hook, "parameters", name)
        usual = Fraction(1, 10**30) if row.type.measured else Fraction(0)
        smallest = usual if row.smallest is None else row.smallest
        for what, remedy, *path in _parameter_faults(name, row, smallest):
            raise file.fault(what, remedy, "parameters", name, *path)
        parameters.append(Parameter(name, row.type, row.low, row.high, row.about, smallest))
    shared = set(Problem.__struct_fields__) & set(Head.__struct_fields__)
    own: dict[str, Any] = {key: getattr(head, key) for key in shared}
    own |= {
        "answer": _type(head.answer.text, folder.parent / "types", head.words),
        "parameters": tuple(parameters),
    }
    where: dict[str, Any] = {"id": folder.name, "folder": folder, "solutions": _solutions(folder)}
    problem = Problem(**own, **where, groups=(), slope=head.growth)
    statement, examples = read_statement(problem, file.raw)
    problem = replace(problem, statement=statement, examples=examples)
    return with_groups(problem, head.tolerance if head.answer.measured else Tolerance())


def made(wanted: Any, value: Any, types: Path) -> Any:
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
    if wanted is not Fraction:
        raise NotImplementedError(wanted)
    if isinstance(value, bool) or not isinstance(value, int | float | Decimal | Fraction):
        raise refusal("{key} is not a number", "give a number")
    number = Decimal(str(value)) if isinstance(value, float) else value
    if isinstance(number, Decimal) and not number.is_finite():
        raise refusal(f"{{key}} is {number}", "give a finite number")
    if isinstance(number, Decimal) and abs(number.adjusted()) > _MOST_DIGITS:
        raise refusal("{key} is absurdly large or small", f"stay within 1e±{_MOST_DIGITS}")
    return Fraction(number)


def _faults(head: Head, raw: Mapping[str, Any]) -> Iterator[Sequence[str]]:
    """What the shape alone does not say: what is wrong, what to do about it, and the keys of the place."""
    from judge.values.types import ArrayType, lasting  # not for who lists problems

    if not _is_plain_name(head.entry):
        yield f"entry {head.entry!r} is no function's name", _PLAIN, "entry"
    if isinstance(lasting(head.answer), ArrayType):
        what = f"no answer can be of the type {head.answer}"
        yield what, "an array is a parameter's; write a list, which may be one too", "answer"
    if head.growth is not None and head.time is None:
        what = "growth is measured beside a reference solution, and there is none"
        yield what, "add a [time] table that names one", "growth"
    for at, name in enumerate(head.sets):
        if not is_name(name):
            yield f"{name!r} is no name for a practice set", _NAME, "sets"
        if name in head.sets[:at]:
            yield f"{name!r} is there twice in sets", "remove one", "sets"
    if head.tolerance is not None and (fault := tolerance_fault(head.tolerance, head.answer)):
        yield fault
    if head.time is not None:
        yield from _time_faults(head.time)
    for key, value in raw.get("source", {}).items():
        for text in (value,) if isinstance(value, str) else value:
            if not text.strip() or not text.isprintable():
                what = f"{key} holds {text!r}, which is no line of text"
                yield what, "write it, or leave the key out", "source", key
            if key == "authors" and ("," in text or "&" in text):
                yield f"{text!r} is more than one name", "give each author's name by itself", "source", key


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


def _time_faults(time: TimeRule) -> Iterator[Sequence[str]]:
    from judge.languages import described, file_name, is_described, is_program
    from judge.problem.toml import meant

    remedy = "name a file of the accepted solutions, such as " + file_name("quadratic")
    for key, name in (("function", time.function), ("program", time.program)):
        if name is not None and not (is_program(name) and Path(name).name == name):
            yield f"{name!r} is no solution's file", remedy, "time", key
    for name in time.needs:
        if not name.isidentifier():
            yield f"{name!r} is no module's name", "name modules such as numpy", "time", "needs"
    for language, name in time.references.items():
        path = ("time", "references", language)
        if not is_described(language):
            yield f"there is no language {language!r}", meant(language, described()), *path
        if not name or Path(name).name != name:
            yield f"{name!r} is no solution's file", remedy, *path


def _parameter_faults(name: str, row: Row, smallest: Fraction) -> Iterator[Sequence[str]]:
    if not _is_plain_name(name):
        yield f"{name!r} is no parameter's name", _PLAIN
    if row.low > row.high:
        yield f"the bounds of {name!r} leave nothing: low is above high", "swap them", "low"
    if not row.type.is_parameter:
        yield f"no parameter can be of the type {row.type}", "an array is a whole parameter", "type"
    if not 0 <= smallest <= 1:
        given = (Decimal(smallest.numerator) / smallest.denominator).normalize()  # no float may hold it
        what = f"the smallest number of {name!r} other than 0 is {given:.6g}"
        yield what, "give 0 to 1: an int other than 0 is never smaller than 1", "smallest"
    if smallest and not row.type.measured:
        yield f"{name!r} holds no real numbers to be small", "remove smallest", "smallest"


def _is_plain_name(name: str) -> bool:
    import keyword

    return name.isidentifier() and name.isascii() and not keyword.iskeyword(name)
