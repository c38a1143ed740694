"""Reading a problem's folder: problem.toml, problem.py and statement.md into one checked Problem.

Every fault is a ProblemError that names the file, the line and what to do.
"""

from __future__ import annotations

import keyword
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Annotated, Any

from msgspec import Meta, Struct
from msgspec.structs import replace

from judge.errors import ProblemError
from judge.languages import described, file_name, is_described, is_program
from judge.problem.kept import KeptProblem
from judge.problem.model import GroupLimits, Parameter, Problem, Source, Tier, TimeRule
from judge.problem.names import is_name
from judge.problem.statement import read_statement
from judge.problem.tables import TomlFile, meant, refusal
from judge.values.answers import Tolerance, Words
from judge.values.atoms import Type
from judge.values.grammar import TypeFault, parse
from judge.values.types import ArrayType, lasting

_MOST_DIGITS = 4_000  # of a number's exponent: Python reads and writes no integer above 4,300 digits
_PLAIN = "use a plain Python name"
_NAME = "use small letters, digits and single hyphens"


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
    parameters: dict[str, Row]  # in the order of the call
    tolerance: Tolerance | None = None
    limits: GroupLimits = GroupLimits()
    time: TimeRule | None = None
    growth: Annotated[float, Meta(gt=0, le=3)] | None = None  # an exponent's excess over the reference's
    words: Words = Words()
    sets: tuple[str, ...] = ()
    place: int | None = None
    source: Source = Source()


def load_problem(folder: Path, solutions: Path | None = None) -> Problem:
    """The problem of that folder; `solutions` is its own folder of solutions.

    By default that is `solutions/<id>` beside the folder of problems. A problem that was read before comes
    from the cache, and nothing of it is run. Raises ProblemError.
    """
    if not is_name(folder.name):
        raise ProblemError(f"{folder.name!r} is no name for a problem", where=str(folder), remedy=_NAME)
    beside = solutions or folder.parent.parent / "solutions" / folder.name
    kept = KeptProblem(folder)
    problem = kept.read(beside)
    if problem is None:
        problem = _read(folder, beside)
        kept.write(problem)
    return problem


def words_beside(folder: Path) -> dict[str, str]:
    """What the placeholders in the texts of that problem's folder stand for. Raises ProblemError."""
    return _words(TomlFile(folder / "problem.toml", exact=True).raw)


def _read(folder: Path, solutions: Path) -> Problem:
    file = TomlFile(folder / "problem.toml", exact=True)
    if "groups" in file.raw:
        remedy = "write GROUPS = [group(name, about, draw), …] there: judge help problem"
        raise file.fault("test groups are declared in problem.py now", remedy, "groups", 0)
    types = folder.parent / "types"
    own = types if types.is_dir() else None
    head = file.read(Head, lambda wanted, value: _made(wanted, value, own))
    _check(file, head)
    problem = Problem(
        id=folder.name,
        title=head.title,
        tier=head.tier,
        summary=head.summary,
        entry=head.entry,
        answer=parse(head.answer.text, own, head.words),
        parameters=tuple(_parameter(file, name, row) for name, row in head.parameters.items()),
        limits=head.limits,
        groups=(),
        folder=folder,
        solutions=solutions,
        time=head.time,
        sets=head.sets,
        place=head.place,
        source=head.source,
    )
    text, examples = read_statement(problem, _words(file.raw))
    problem = replace(problem, statement=text, examples=examples)
    from judge.problem.rows import with_rows  # runs problem.py: not for who reads the cache

    tolerance = head.tolerance if head.answer.measured else Tolerance()
    return with_rows(problem, tolerance, head.growth)


def _made(wanted: Any, value: Any, types: Path | None) -> Any:
    """A Fraction or a Type of what stands in the file."""
    if wanted is Type:
        if not isinstance(value, str):
            raise refusal("{key} is not text", 'give a type in quotes, such as "integer"')
        try:
            return parse(value, types)
        except TypeFault as fault:
            raise refusal(f"{{key}} = {fault.what}", fault.remedy) from None
    if wanted is Fraction:
        if isinstance(value, bool) or not isinstance(value, int | Decimal):
            raise refusal("{key} is not a number", "give a number")
        if isinstance(value, Decimal) and not value.is_finite():
            raise refusal(f"{{key}} is {value}", "give a finite number")
        if isinstance(value, Decimal) and abs(value.adjusted()) > _MOST_DIGITS:
            raise refusal("{key} is absurdly large or small", f"stay within 1e±{_MOST_DIGITS}")
        return Fraction(value)
    raise NotImplementedError(wanted)


def _check(file: TomlFile, head: Head) -> None:
    """What the shape alone does not say."""
    if not _is_plain_name(head.entry):
        raise file.fault(f"entry {head.entry!r} is no function's name", _PLAIN, "entry")
    if isinstance(lasting(head.answer), ArrayType):
        what = f"no answer can be of the type {head.answer}"
        raise file.fault(what, "an array is a parameter's; write a list, which may be one too", "answer")
    if head.growth is not None and head.time is None:
        what = "growth is measured beside a reference solution, and there is none"
        raise file.fault(what, "add a [time] table that names one", "growth")
    for at, name in enumerate(head.sets):
        if not is_name(name):
            raise file.fault(f"{name!r} is no name for a practice set", _NAME, "sets", at)
        if name in head.sets[:at]:
            raise file.fault(f"{name!r} is there twice in sets", "remove one", "sets", at)
    _check_tolerance(file, head)
    if head.time is not None:
        _check_time(file, head.time)
    for key, texts in (
        ("authors", head.source.authors),
        ("license", (head.source.license,) if "license" in file.raw.get("source", {}) else ()),
        ("origin", (head.source.origin,) if "origin" in file.raw.get("source", {}) else ()),
    ):
        for text in texts:
            if not text.strip() or not text.isprintable():
                what = f"{key} holds {text!r}, which is no line of text"
                raise file.fault(what, "write it, or leave the key out", "source", key)
            if key == "authors" and ("," in text or "&" in text):
                what = f"{text!r} is more than one name"
                raise file.fault(what, "give each author's name by itself", "source", key)


def _check_tolerance(file: TomlFile, head: Head) -> None:
    tolerance = head.tolerance
    if tolerance is None:
        return
    if not head.answer.measured:
        what = "an answer without real numbers is right or wrong and has no tolerance"
        raise file.fault(what, "remove it", "tolerance")
    for key in tolerance.__struct_fields__:
        if getattr(tolerance, key) < 0:
            raise file.fault(f"the tolerance {key} is negative", "give 0 or more", "tolerance", key)
    if not (tolerance.extent or tolerance.relative or tolerance.ulps):
        what = "the tolerance is 0, which no double can meet"
        raise file.fault(what, "give relative, extent or ulps", "tolerance")


def _check_time(file: TomlFile, time: TimeRule) -> None:
    for key, name in (("function", time.function), ("program", time.program)):
        if name is not None and not (is_program(name) and Path(name).name == name):
            remedy = "name a file of the accepted solutions, such as " + file_name("quadratic")
            raise file.fault(f"{name!r} is no solution's file", remedy, "time", key)
    for name in time.needs:
        if not name.isidentifier():
            raise file.fault(f"{name!r} is no module's name", "name modules such as numpy", "time", "needs")
    for language, name in time.references.items():
        path = ("time", "references", language)
        if not is_described(language):
            raise file.fault(f"there is no language {language!r}", meant(language, described()), *path)
        if not name or Path(name).name != name:
            raise file.fault(
                f"{name!r} is no solution's file", "name a file of the accepted solutions", *path
            )


def _parameter(file: TomlFile, name: str, row: Row) -> Parameter:
    path = ("parameters", name)
    if not _is_plain_name(name):
        raise file.fault(f"{name!r} is no parameter's name", _PLAIN, *path)
    if row.low > row.high:
        what = f"the bounds of {name!r} leave nothing: low is above high"
        raise file.fault(what, "swap them", *path, "low")
    if not row.type.is_parameter:
        what = f"no parameter can be of the type {row.type}"
        raise file.fault(what, "an array is a whole parameter", *path, "type")
    usual = Fraction(1, 10**30) if row.type.measured else Fraction(0)
    smallest = usual if row.smallest is None else row.smallest
    if not 0 <= smallest <= 1:
        given = (Decimal(smallest.numerator) / smallest.denominator).normalize()  # no float may hold it
        what = f"the smallest number of {name!r} other than 0 is {given:.6g}"
        remedy = "give 0 to 1: an int other than 0 is never smaller than 1"
        raise file.fault(what, remedy, *path, "smallest")
    if smallest and not row.type.measured:
        raise file.fault(f"{name!r} holds no real numbers to be small", "remove smallest", *path, "smallest")
    return Parameter(name, row.type, row.low, row.high, row.about, smallest)


def _is_plain_name(name: str) -> bool:
    return name.isidentifier() and name.isascii() and not keyword.iskeyword(name)


def _words(raw: Mapping[str, Any]) -> dict[str, str]:
    """What the placeholders of texts stand for: each number as the file writes it."""
    words = {name: str(raw.get(name, "")) for name in ("entry", "title", "answer")}
    usual = GroupLimits()
    limits = {key: f"{getattr(usual, key):g}" for key in usual.__struct_fields__} | raw.get("limits", {})
    words |= {f"limits.{key}": _written(value) for key, value in limits.items()}
    if tolerance := raw.get("tolerance"):
        every = dict.fromkeys(Tolerance.__struct_fields__, 0) | tolerance
        words |= {f"tolerance.{key}": _written(value) for key, value in every.items()}
    for name, row in raw.get("parameters", {}).items():
        words[f"{name}.type"] = row.get("type", "")
        for key, value in (("low", -(2**30)), ("high", 2**30), ("smallest", 0)):
            words[f"{name}.{key}"] = _written(row.get(key, value))
    return words


def _written(number: Any) -> str:
    small = isinstance(number, Decimal) and 0 < abs(number) < Decimal("1e-4")  # 1e-6, as well as 1e-7
    return (f"{number:e}" if small else str(number)).lower().replace("e+", "e")
