"""Reading a problem's folder: problem.toml and statement.md into one checked Problem.

Every fault is a ProblemError that names the file, the line and what to do.
"""

from __future__ import annotations

import keyword
import re
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from types import MappingProxyType
from typing import Any

import msgspec
from msgspec.structs import replace

from judge.errors import ProblemError
from judge.languages import described, file_name, is_described, is_program
from judge.problem import schema
from judge.problem.growing import MOST_INPUT_MB, GrowingKeys
from judge.problem.level import level_fault
from judge.problem.lines import KeyPath
from judge.problem.model import EXAMPLES, Group, GroupLimits, Parameter, Problem, ShownSkill, TimeRule
from judge.problem.source import source_of
from judge.problem.statement import read_statement
from judge.problem.tomlfile import TomlFile, meant
from judge.problem.verdict import FULL_SCORE
from judge.values import Tolerance, Type, TypeFault, Words, parse

_MOST_CASES = 1_000_000
_MOST_DIGITS = 4_000  # of a number's exponent: Python reads and writes no integer above 4,300 digits
_LEAST_LIMIT, _MOST_LIMIT = Fraction(1, 1000), 1_000_000  # of seconds, megabytes and multiples
_DEEPEST = 10  # lists in lists of a builder's parameter
_NAME = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")
_MEGABYTE = 2**20


def load_problem(folder: Path, solutions: Path | None = None) -> Problem:
    """The problem of that folder; `solutions` is its own folder of solutions.

    By default that is `solutions/<id>` beside the folder of problems. Raises ProblemError.
    """
    if not is_name(folder.name):
        raise ProblemError(
            f"{folder.name!r} is no name for a problem",
            where=str(folder),
            remedy="use small letters, digits and single hyphens",
        )
    reader = _Reader(folder)
    return reader.problem(solutions or folder.parent.parent / "solutions" / folder.name)


def is_name(text: str) -> bool:
    """Whether a problem, a group or a set may be called so: small letters, digits and single hyphens."""
    return _NAME.fullmatch(text) is not None


def words_beside(folder: Path) -> dict[str, str]:
    """What the placeholders in the texts of that problem's folder stand for. Raises ProblemError."""
    return _words(TomlFile(folder).table())


class _Reader:
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
        bands = self.bands(table)
        limits = self._limits(table.limits)
        growing = GrowingKeys(table, limits, self.fault, self._exact)
        groups = tuple(
            growing.group(group, table.groups[at], ("groups", at))
            for at, group in enumerate(self._groups(table))
        )
        problem = Problem(
            id=self.folder.name,
            title=table.title,
            tier=table.tier,
            summary=table.summary,
            entry=table.entry,
            answer=self._answer(table),
            parameters=self._parameters(table),
            bands=bands,
            limits=limits,
            groups=groups,
            folder=self.folder,
            solutions=solutions,
            time=self._time(table.time),
            sets=self._sets(table.sets),
            place=table.place,
            skills=self._skills(table),
            growth=growing.growth(groups),
            source=source_of(table.source, self.fault),
        )
        text, examples = read_statement(problem, _words(table))
        groups = tuple(
            replace(group, count=len(examples)) if group.builder == EXAMPLES else group
            for group in problem.groups
        )
        return replace(problem, statement=text, examples=examples, groups=groups)

    def bands(self, table: schema.ProblemTable) -> MappingProxyType[str, Fraction]:
        """The named widths, each above 0."""
        widths = {name: self._exact(value, ("bands", name)) for name, value in table.bands.items()}
        for name, width in widths.items():
            if width <= 0:
                self.fault(("bands", name), f"the band {name!r} has no width", "give a number above 0")
        return MappingProxyType(widths)

    def _parameters(self, table: schema.ProblemTable) -> tuple[Parameter, ...]:
        self._unique("parameters", [parameter.name for parameter in table.parameters])
        return tuple(self._parameter(each, ("parameters", at)) for at, each in enumerate(table.parameters))

    def _parameter(self, table: schema.ParameterTable, path: KeyPath) -> Parameter:
        if not _is_plain_name(table.name):
            self.fault((*path, "name"), f"{table.name!r} is no parameter's name", "use a plain Python name")
        low, high = self._exact(table.low, (*path, "low")), self._exact(table.high, (*path, "high"))
        if low > high:
            self.fault(
                (*path, "low"), f"the bounds of {table.name!r} leave nothing: low is above high", "swap them"
            )
        type_ = self._type(table.type, (*path, "type"))
        if not type_.is_parameter:
            what = f"no parameter can be of the type {table.type}"
            self.fault((*path, "type"), what, "an enclosure is an answer; an array is a whole parameter")
        return Parameter(table.name, type_, low, high, table.about, self._smallest(table, type_, path))

    def _smallest(self, table: schema.ParameterTable, type_: Type, path: KeyPath) -> Fraction:
        smallest = self._exact(table.smallest, (*path, "smallest"))
        if not 0 <= smallest <= 1:
            self.fault(
                (*path, "smallest"),
                f"the smallest number of {table.name!r} other than 0 is {table.smallest}",
                "give 0 to 1: an int other than 0 is never smaller than 1",
            )
        if smallest and not type_.measured:
            self.fault(
                (*path, "smallest"), f"{table.name!r} holds no real numbers to be small", "remove smallest"
            )
        return smallest

    def _answer(self, table: schema.ProblemTable) -> Type:
        if self._known_answer is None:
            own = Words(**msgspec.structs.asdict(table.words)) if table.words else Words()
            self._known_answer = self._type(table.answer, ("answer",)).worded(own)
        return self._known_answer

    def _type(self, text: str, path: KeyPath) -> Type:
        types = self.folder.parent / "types"
        try:
            return parse(text, types if types.is_dir() else None)
        except TypeFault as fault:
            self.fault(path, f"{path[-1]} = {fault.what}", fault.remedy)

    def _limits(self, table: schema.LimitsTable) -> GroupLimits:
        for key in table.__struct_fields__:
            limit = self._exact(getattr(table, key), ("limits", key))
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
        limit = self._exact(table.limit, ("time", "limit"))
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

    def _references(self, table: schema.TimeTable) -> MappingProxyType[str, str]:
        for language, name in table.references.items():
            path = ("time", "references", language)
            if not is_described(language):
                self.fault(path, f"there is no language {language!r}", meant(language, described()))
            if not name or Path(name).name != name:
                remedy = "name a file of the accepted solutions"
                self.fault(path, f"{name!r} is no solution's file", remedy)
        return MappingProxyType(table.references)

    def _sensible(self, limit: Fraction, path: KeyPath) -> None:
        if not _LEAST_LIMIT <= limit <= _MOST_LIMIT:
            remedy = f"stay within {float(_LEAST_LIMIT):g} and {_MOST_LIMIT}"
            self.fault(path, f"{path[-1]} is absurdly large or small", remedy)

    def _groups(self, table: schema.ProblemTable) -> tuple[Group, ...]:
        if not table.groups:
            self.fault(("groups",), "there are no test groups", "add a [[groups]] table")
        self._unique("groups", [group.name for group in table.groups])
        total = sum(group.points for group in table.groups)
        if total != FULL_SCORE:
            what = f"the groups' points sum to {total}"
            self.fault(("groups", 0, "points"), what, f"make them sum to {FULL_SCORE}")
        if mixed := level_fault([(group.name, group.level) for group in table.groups]):
            self.fault(("groups", mixed[0]), *mixed[1:])
        return tuple(self._group(each, table, ("groups", at)) for at, each in enumerate(table.groups))

    def _group(self, group: schema.GroupTable, table: schema.ProblemTable, path: KeyPath) -> Group:
        if not is_name(group.name):
            remedy = "use small letters, digits and single hyphens"
            self.fault((*path, "name"), f"{group.name!r} is no name for a group", remedy)
        if group.points < 0:
            self.fault((*path, "points"), f"group {group.name!r} has negative points", "give 0 to 100")
        if len(set(group.kills)) < len(group.kills):
            self.fault((*path, "kills"), f"group {group.name!r} names a mistake twice", "remove one")
        seed, count = self._seed_and_count(group, path)
        return Group(
            name=group.name,
            about=group.about,
            builder=group.builder,
            parameters=MappingProxyType(
                {
                    name: self._argument(value, (*path, "parameters", name))
                    for name, value in group.parameters.items()
                }
            ),
            seed=seed,
            count=count,
            points=group.points,
            tolerance=self._tolerance(group, table, path),
            kills=tuple(group.kills),
            neighbours=self._neighbours(group, path),
            level=group.level,
        )

    def _neighbours(self, group: schema.GroupTable, path: KeyPath) -> bool:
        if group.neighbours and (group.builder == EXAMPLES or group.size is not None):
            what = "examples and big cases are no neighbours of one another"
            self.fault((*path, "neighbours"), what, "remove neighbours")
        return group.neighbours

    def _seed_and_count(self, group: schema.GroupTable, path: KeyPath) -> tuple[int, int]:
        """A group's seed and number of cases; both 0 for the examples, whose number the statement says."""
        if group.builder == EXAMPLES:
            for key in ("seed", "count", "parameters"):
                if getattr(group, key):
                    self.fault((*path, key), f"the examples take no {key}", f"remove {key}")
            return 0, 0
        if group.seed is None or group.count is None:
            missing = "seed" if group.seed is None else "count"
            self.fault(path, f"group {group.name!r} has no {missing}", f"add {missing} = …")
        if group.seed < 0:
            self.fault((*path, "seed"), f"the seed of group {group.name!r} is negative", "give 0 or more")
        if not 1 <= group.count <= _MOST_CASES:
            self.fault(
                (*path, "count"), f"group {group.name!r} has {group.count} cases", f"give 1 to {_MOST_CASES}"
            )
        return group.seed, group.count

    def _tolerance(self, group: schema.GroupTable, table: schema.ProblemTable, path: KeyPath) -> Tolerance:
        own = group.tolerance is not None
        given = group.tolerance or table.tolerance
        place: KeyPath = (*path, "tolerance") if own else ("tolerance",)
        if not self._answer(table).measured:
            if given is not None:
                what = "an answer without real numbers is right or wrong and has no tolerance"
                self.fault(place, what, "remove it")
            return Tolerance()
        if given is None:
            self.fault(path, f"group {group.name!r} has no tolerance", "add a [tolerance] table")
        exact = {key: self._exact(getattr(given, key), (*place, key)) for key in given.__struct_fields__}
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

    def _skills(self, table: schema.ProblemTable) -> tuple[ShownSkill, ...]:
        names = [group.name for group in table.groups]
        return tuple(self._skill(skill, entry, names) for skill, entry in table.skills.items())

    def _skill(self, skill: str, entry: Any, names: list[str]) -> ShownSkill:
        path: KeyPath = ("skills", skill)
        if isinstance(entry, dict):
            own = self.file.shaped(entry, schema.SkillTable, path)
            groups, about, path = own.groups, own.about, (*path, "groups")
        else:
            groups, about = self.file.shaped(entry, list[str], path), None
        if not skill.strip():
            self.fault(path, "a skill has no name", "write what the groups show in a few words")
        if about is not None and not about.strip():
            self.fault(("skills", skill, "about"), f"{skill!r} is not explained", "write one sentence")
        if not groups:
            self.fault(path, f"no group shows {skill!r}", "name at least one")
        for at, group in enumerate(groups):
            if group not in names:
                self.fault(path, f"there is no group {group!r} to show {skill!r}", meant(group, names))
            if group in groups[:at]:
                self.fault(path, f"{skill!r} names the group {group!r} twice", "remove one")
        return ShownSkill(skill, tuple(groups), about)

    def _argument(self, value: Any, path: KeyPath, depth: int = 0) -> Any:
        """A builder's parameter: exact (a Fraction where the file has a decimal point) and unchangeable."""
        if isinstance(value, Decimal):
            return self._exact(value, path)
        if isinstance(value, list) and depth < _DEEPEST:
            return tuple(self._argument(each, path, depth + 1) for each in value)
        if isinstance(value, bool | int | str):
            return value
        return self.fault(
            path, f"a builder cannot take {value!r}", "give a number, text, true or false, or a list"
        )

    def _exact(self, value: schema.TomlNumber, path: KeyPath) -> Fraction:
        if isinstance(value, Decimal):
            if not value.is_finite():
                self.fault(path, f"{path[-1]} is {value}", "give a finite number")
            if abs(value.adjusted()) > _MOST_DIGITS:
                self.fault(path, f"{path[-1]} is absurdly large or small", f"stay within 1e±{_MOST_DIGITS}")
        return Fraction(value)

    def _unique(self, key: str, names: list[str]) -> None:
        for at, name in enumerate(names):
            if name in names[:at]:
                self.fault((key, at, "name"), f"{name!r} is there twice in {key}", "rename or remove one")


def _is_plain_name(name: str) -> bool:
    return name.isidentifier() and name.isascii() and not keyword.iskeyword(name)


def _words(table: schema.ProblemTable) -> dict[str, str]:
    """What the statement's placeholders stand for: each number as the file writes it."""
    words = {"entry": table.entry, "title": table.title, "answer": table.answer}
    words |= {name: _written(width) for name, width in table.bands.items()}
    for parameter in table.parameters:
        words[f"{parameter.name}.type"] = parameter.type
        words[f"{parameter.name}.low"] = _written(parameter.low)
        words[f"{parameter.name}.high"] = _written(parameter.high)
        words[f"{parameter.name}.smallest"] = _written(parameter.smallest)
    words |= _numbers("tolerance", table.tolerance)
    words |= _numbers("limits", table.limits)
    for group in table.groups:
        words |= _numbers(f"{group.name}.tolerance", group.tolerance)
        if group.count is not None:
            words[f"{group.name}.count"] = _written(group.count)
    return words


def _numbers(prefix: str, table: schema.ToleranceTable | schema.LimitsTable | None) -> dict[str, str]:
    if table is None:
        return {}
    return {f"{prefix}.{key}": _written(getattr(table, key)) for key in table.__struct_fields__}


def _written(number: schema.TomlNumber) -> str:
    small = isinstance(number, Decimal) and 0 < abs(number) < Decimal("1e-4")  # 1e-6, as well as 1e-7
    return (f"{number:e}" if small else str(number)).lower().replace("e+", "e")
