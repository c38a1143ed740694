"""Reading a problem's folder: problem.toml and statement.md into one checked Problem.

Every fault is a ProblemError that names the file, the line and what to do.
"""

from __future__ import annotations

import keyword
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import msgspec
from msgspec.structs import replace

from judge.errors import ProblemError
from judge.languages import described, file_name, is_described, is_program
from judge.problem import schema
from judge.problem.kept import KeptProblem
from judge.problem.lines import KeyPath
from judge.problem.model import GroupLimits, Parameter, Problem, TimeRule
from judge.problem.names import is_name
from judge.problem.source import source_of
from judge.problem.statement import read_statement
from judge.problem.tomlfile import TomlFile, meant
from judge.values import Tolerance, Type, TypeFault, Words, parse

_MOST_DIGITS = 4_000  # of a number's exponent: Python reads and writes no integer above 4,300 digits
_LEAST_LIMIT, _MOST_LIMIT = Fraction(1, 1000), 1_000_000  # of seconds, megabytes and multiples
_MEGABYTE = 2**20
MOST_INPUT_MB = 72  # what a container's memory has room for beside the answers


def load_problem(folder: Path, solutions: Path | None = None) -> Problem:
    """The problem of that folder; `solutions` is its own folder of solutions.

    By default that is `solutions/<id>` beside the folder of problems. A problem that was read before comes
    from the cache, and nothing of it is run. Raises ProblemError.
    """
    if not is_name(folder.name):
        raise ProblemError(
            f"{folder.name!r} is no name for a problem",
            where=str(folder),
            remedy="use small letters, digits and single hyphens",
        )
    beside = solutions or folder.parent.parent / "solutions" / folder.name
    kept = KeptProblem(folder)
    problem = kept.read(beside)
    if problem is None:
        problem = Reader(folder).problem(beside)
        kept.write(problem)
    return problem


def words_beside(folder: Path) -> dict[str, str]:
    """What the placeholders in the texts of that problem's folder stand for. Raises ProblemError."""
    return _words(TomlFile(folder).table())


class Reader:
    """The checks of one problem.toml."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.file = TomlFile(folder)
        self.fault = self.file.fault
        self._known_answer: Type | None = None

    def problem(self, solutions: Path) -> Problem:
        """Everything, checked."""
        table = self.file.table()
        if not _is_plain_name(table.entry):
            self.fault(("entry",), f"entry {table.entry!r} is no function's name", "use a plain Python name")
        problem = Problem(
            id=self.folder.name,
            title=table.title,
            tier=table.tier,
            summary=table.summary,
            entry=table.entry,
            answer=self.answer(table),
            parameters=self._parameters(table),
            limits=self._limits(table.limits),
            groups=(),
            folder=self.folder,
            solutions=solutions,
            time=self._time(table.time),
            sets=self._sets(table.sets),
            place=table.place,
            source=source_of(table.source, self.fault),
        )
        tolerance = self._tolerance(table.tolerance)
        text, examples = read_statement(problem, _words(table))
        problem = replace(problem, statement=text, examples=examples)
        from judge.problem.rows import with_rows  # runs problem.py: not for who reads the cache

        return with_rows(problem, tolerance, self._growth(table))

    def _growth(self, table: schema.ProblemTable) -> float | None:
        """By how much the exponent of a submission's time may exceed the reference's."""
        if table.growth is None:
            return None
        if table.time is None:
            what = "growth is measured beside a reference solution, and there is none"
            self.fault(("growth",), what, "add a [time] table that names one")
        slope = self.exact(table.growth, ("growth",))
        if not 0 < slope <= 3:
            self.fault(("growth",), "the slope is no difference of exponents", "give 0.1 to 3")
        return float(slope)

    def _parameters(self, table: schema.ProblemTable) -> tuple[Parameter, ...]:
        return tuple(
            self._parameter(name, row, ("parameters", name)) for name, row in table.parameters.items()
        )

    def _parameter(self, name: str, table: schema.ParameterRow, path: KeyPath) -> Parameter:
        if not _is_plain_name(name):
            self.fault((*path, "name"), f"{name!r} is no parameter's name", "use a plain Python name")
        low, high = self.exact(table.low, (*path, "low")), self.exact(table.high, (*path, "high"))
        if low > high:
            self.fault(
                (*path, "low"), f"the bounds of {name!r} leave nothing: low is above high", "swap them"
            )
        type_ = self._type(table.type, (*path, "type"))
        if not type_.is_parameter:
            what = f"no parameter can be of the type {table.type}"
            self.fault((*path, "type"), what, "an array is a whole parameter")
        least = table.smallest
        if least is None:
            least = Decimal("1e-30") if type_.measured else 0
        return Parameter(name, type_, low, high, table.about, self._smallest(name, least, type_, path))

    def _smallest(self, name: str, given: schema.TomlNumber, type_: Type, path: KeyPath) -> Fraction:
        smallest = self.exact(given, (*path, "smallest"))
        if not 0 <= smallest <= 1:
            self.fault(
                (*path, "smallest"),
                f"the smallest number of {name!r} other than 0 is {given}",
                "give 0 to 1: an int other than 0 is never smaller than 1",
            )
        if smallest and not type_.measured:
            self.fault((*path, "smallest"), f"{name!r} holds no real numbers to be small", "remove smallest")
        return smallest

    def answer(self, table: schema.ProblemTable) -> Type:
        """The type of an answer."""
        if self._known_answer is None:
            own = Words(**msgspec.structs.asdict(table.words)) if table.words else Words()
            answer = self._type(table.answer, ("answer",))
            if not answer.is_answer:
                what = f"no answer can be of the type {table.answer}"
                self.fault(("answer",), what, "an array is a parameter's; write a list, which may be one too")
            self._known_answer = answer.worded(own)
        return self._known_answer

    def _type(self, text: str, path: KeyPath) -> Type:
        types = self.folder.parent / "types"
        try:
            return parse(text, types if types.is_dir() else None)
        except TypeFault as fault:
            self.fault(path, f"{path[-1]} = {fault.what}", fault.remedy)

    def _limits(self, table: schema.LimitsTable) -> GroupLimits:
        for key in table.__struct_fields__:
            limit = self.exact(getattr(table, key), ("limits", key))
            if limit <= 0:
                self.fault(("limits", key), f"{key} allows nothing", "give a number above 0")
            self._sensible(limit, ("limits", key))
        if table.input_mb > MOST_INPUT_MB:
            remedy = f"give at most {MOST_INPUT_MB}"
            self.fault(("limits", "input_mb"), f"there is no room for {table.input_mb} MB of cases", remedy)
        return GroupLimits(
            cpu_seconds=float(table.cpu_seconds),
            wall_seconds=float(table.wall_seconds),
            memory_bytes=int(table.memory_mb * _MEGABYTE),
            output_bytes=int(table.output_mb * _MEGABYTE),
            input_bytes=int(table.input_mb * _MEGABYTE),
        )

    def _time(self, table: schema.TimeTable | None) -> TimeRule | None:
        if table is None:
            return None
        limit = self.exact(table.limit, ("time", "limit"))
        if limit < 1:
            self.fault(("time", "limit"), "the reference itself would be too slow", "give a multiple above 1")
        self._sensible(limit, ("time", "limit"))
        for key, name in (("function", table.function), ("program", table.program)):
            if name is not None and not (is_program(name) and Path(name).name == name):
                remedy = "name a file of the accepted solutions, such as " + file_name("quadratic")
                self.fault(("time", key), f"{name!r} is no solution's file", remedy)
        for name in table.needs:
            if not name.isidentifier():
                self.fault(("time", "needs"), f"{name!r} is no module's name", "name modules such as numpy")
        references = self._references(table)
        return TimeRule(float(table.limit), table.function, table.program, tuple(table.needs), references)

    def _references(self, table: schema.TimeTable) -> dict[str, str]:
        for language, name in table.references.items():
            path = ("time", "references", language)
            if not is_described(language):
                self.fault(path, f"there is no language {language!r}", meant(language, described()))
            if not name or Path(name).name != name:
                remedy = "name a file of the accepted solutions"
                self.fault(path, f"{name!r} is no solution's file", remedy)
        return table.references

    def _sensible(self, limit: Fraction, path: KeyPath) -> None:
        if not _LEAST_LIMIT <= limit <= _MOST_LIMIT:
            remedy = f"stay within {float(_LEAST_LIMIT):g} and {_MOST_LIMIT}"
            self.fault(path, f"{path[-1]} is absurdly large or small", remedy)

    def _tolerance(self, given: schema.ToleranceTable | None) -> Tolerance | None:
        """The tolerance, if one is given; of an answer without reals there is none."""
        place = ("tolerance",)
        assert self._known_answer is not None, "the answer's type is read first"
        if not self._known_answer.measured:
            if given is not None:
                what = "an answer without real numbers is right or wrong and has no tolerance"
                self.fault(place, what, "remove it")
            return Tolerance()
        if given is None:
            return None
        exact = {key: self.exact(getattr(given, key), (*place, key)) for key in given.__struct_fields__}
        for key, width in exact.items():
            if width < 0:
                self.fault((*place, key), f"the tolerance {key} is negative", "give 0 or more")
        tolerance = Tolerance(**exact)
        if not (tolerance.extent or tolerance.relative or tolerance.ulps):
            self.fault(place, "the tolerance is 0, which no double can meet", "give relative, extent or ulps")
        return tolerance

    def _sets(self, names: list[str]) -> tuple[str, ...]:
        for at, name in enumerate(names):
            if not is_name(name):
                remedy = "use small letters, digits and single hyphens"
                self.fault(("sets", at), f"{name!r} is no name for a practice set", remedy)
            if name in names[:at]:
                self.fault(("sets", at), f"{name!r} is there twice in sets", "remove one")
        return tuple(names)

    def exact(self, value: schema.TomlNumber, path: KeyPath) -> Fraction:
        """The number that stands at `path`, as it is written."""
        if isinstance(value, Decimal):
            if not value.is_finite():
                self.fault(path, f"{path[-1]} is {value}", "give a finite number")
            if abs(value.adjusted()) > _MOST_DIGITS:
                self.fault(path, f"{path[-1]} is absurdly large or small", f"stay within 1e±{_MOST_DIGITS}")
        return Fraction(value)


def _is_plain_name(name: str) -> bool:
    return name.isidentifier() and name.isascii() and not keyword.iskeyword(name)


def _words(table: schema.ProblemTable) -> dict[str, str]:
    """What the statement's placeholders stand for: each number as the file writes it."""
    words = {"entry": table.entry, "title": table.title, "answer": table.answer}
    words |= _numbers("tolerance", table.tolerance)
    words |= _numbers("limits", table.limits)
    for name, row in table.parameters.items():
        words |= {
            f"{name}.type": row.type,
            f"{name}.low": _written(row.low),
            f"{name}.high": _written(row.high),
        }
        words[f"{name}.smallest"] = _written(row.smallest or 0)
    return words


def _numbers(prefix: str, table: schema.ToleranceTable | schema.LimitsTable | None) -> dict[str, str]:
    if table is None:
        return {}
    return {f"{prefix}.{key}": _written(getattr(table, key)) for key in table.__struct_fields__}


def _written(number: schema.TomlNumber) -> str:
    small = isinstance(number, Decimal) and 0 < abs(number) < Decimal("1e-4")  # 1e-6, as well as 1e-7
    return (f"{number:e}" if small else str(number)).lower().replace("e+", "e")
