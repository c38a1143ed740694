"""What a problem is: read from its folder once, checked, and never changed."""

from __future__ import annotations

import keyword
import re
from collections.abc import Mapping, Sequence
from enum import Enum
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Annotated, Any, Self

from msgspec import Meta, Struct

from judge.errors import ProblemError, UsageError, meant
from judge.values.answers import Tolerance, Words
from judge.values.atoms import Type

Argument = Any  # a number, a word, a text, a bool, None, or a tuple of such: what the parameter's type says
Case = tuple[Argument, ...]  # the arguments of one call, in the order of the problem's parameters

EXAMPLES = "examples"  # the group of the statement's worked examples
FULL_SCORE = 100  # what the points of a problem's groups sum to
MOST_INPUT_MB = 72  # what a container's memory has room for beside the answers
_MEGABYTE = 2**20
Bound = Annotated[float, Meta(ge=1e-3, le=1e6)]
# Patterns of texts, each with what to use.
NAME = r"^[a-z][a-z0-9]*(-[a-z0-9]+)*\Z"
_PYTHON = rf"^(?!(?:{'|'.join(keyword.kwlist)})\Z)[A-Za-z_]\w*\Z"
_ENTRY = rf"{_PYTHON}|^\Z"
_FILE = r"^[^./\\][^/\\]*\Z"
_LINE = r"^(\S[^\x00-\x1f]*)?\Z"
_AUTHOR = r"^\S[^\x00-\x1f,&]*\Z"
TEXT = r"\S"
FORMS = {
    TEXT: "a sentence",
    NAME: "small letters, digits and single hyphens",
    _PYTHON: "a plain Python name",
    _ENTRY: "a plain Python name",
    _FILE: "the name of a file of the accepted solutions",
    _LINE: "a line of text, or leave the key out",
    _AUTHOR: "each author's name by itself",
}
Name = Annotated[str, Meta(pattern=NAME)]
PythonName = Annotated[str, Meta(pattern=_PYTHON)]
FileName = Annotated[str, Meta(pattern=_FILE)]


def is_name(text: str) -> bool:
    """Whether a problem, a group or a set may be called so."""
    return re.match(NAME, text) is not None


def is_solution(path: str, problem: str) -> bool:
    """Whether a path, with / between its parts, names a solution of the problem of that id."""
    return path.split("/")[-4:-2] == ["solutions", problem]


def case_of(arguments: Mapping[str, Any]) -> Case:
    """The case of arguments by parameter name, also where JSON has made lists of tuples."""
    return tuple(map(tupled, arguments.values()))


def tupled(value: Any) -> Any:
    """The value with a tuple in place of every list, at every level."""
    if isinstance(value, dict):
        return {key: tupled(each) for key, each in value.items()}
    return tuple(map(tupled, value)) if isinstance(value, tuple | list) else value


class _Explained(Enum):
    """Members with a name, which is the value and stands in JSON, and what they mean."""

    _value_: str
    meaning: str

    def __new__(cls, name: str, meaning: str = "") -> Self:
        """A member."""
        made = object.__new__(cls)
        made._value_, made.meaning = name, meaning
        return made


class KataLevel(_Explained):
    """What a test group belongs to, the easier first; the meaning is what its groups ask of a program."""

    INTERVIEW = "interview", "the kinds of cases there are, at sizes that a textbook has"
    PRODUCTION = (
        "production",
        "sizes from tiny to huge, places far from the origin, near touches, last digits, growth",
    )


LEVELS = tuple(level.value for level in KataLevel)


class Verdict(_Explained):
    """The outcome of a test group or of a whole submission."""

    AC = "AC", "accepted"
    WA = "WA", "wrong answer"
    TLE = "TLE", "time limit exceeded"
    MLE = "MLE", "memory limit exceeded"
    OLE = "OLE", "output limit exceeded"
    RTE = "RTE", "run-time error"
    CE = "CE", "does not compile"
    JE = "JE", "could not be judged"


class Mode(Enum):
    """How a submission is run."""

    FUNCTION = "function"  # its entry function is called
    PROGRAM = "program"  # it reads stdin and writes stdout


FIRST = "first-steps"  # the set that a newcomer begins with


class Tier(Enum):
    """How far along the path a problem stands, easiest first."""

    JUNIOR = "junior"
    MIDDLE = "middle"
    SENIOR = "senior"
    PROFESSIONAL = "professional"


class Parameter(Struct, frozen=True, forbid_unknown_fields=True, cache_hash=True):
    """A row of `[parameters]`: `cx = { type = "number", about = "x of the centre" }`.

    `low` and `high` bound each of its numbers, ends included, and are those of its type where that has such.
    A real number other than 0 is at least `smallest` in magnitude: 1e-30 where nothing is said of it.
    `letters` are those of its texts, `a-z` for a range; None where the setter names none.
    """

    name: PythonName
    type: Type
    about: str
    low: Fraction = Fraction(-(2**30))
    high: Fraction = Fraction(2**30)
    smallest: Fraction = Fraction(1, 10**30)
    letters: str | None = None


class GroupLimits(Struct, frozen=True, forbid_unknown_fields=True):
    """`[limits]`: the bounds of one test group, all its calls together or its one program."""

    cpu_seconds: Bound = 2
    wall_seconds: Bound = 6
    memory_mb: Bound = 256  # of 2**20 bytes
    output_mb: Bound = 16
    input_mb: Annotated[float, Meta(ge=1e-3, le=MOST_INPUT_MB)] = 64  # of its cases, as a function gets them

    @property
    def memory_bytes(self) -> int:
        """The memory."""
        return int(self.memory_mb * _MEGABYTE)

    @property
    def output_bytes(self) -> int:
        """All that is returned or printed."""
        return int(self.output_mb * _MEGABYTE)

    @property
    def input_bytes(self) -> int:
        """The most that the cases may hold."""
        return int(self.input_mb * _MEGABYTE)


class TimeRule(Struct, frozen=True, forbid_unknown_fields=True):
    """`[time]`: the limit, how many times the CPU time of a reference solution a submission may use.

    The references are files of `solutions/<id>/accepted`; `program` is for submissions run as programs, and
    `function` is there unless all are.
    `needs` are the modules that they import and that do not come with Python. `references` are functions in
    other languages, by the language's id.
    """

    limit: Annotated[float, Meta(ge=1, le=1e6)]
    function: FileName | None = None
    program: FileName | None = None
    needs: tuple[PythonName, ...] = ()
    references: dict[str, FileName] = {}


class GrowthRule(Struct, frozen=True):
    """How CPU time may grow: by n to a power that exceeds the reference solution's by no more than `slope`.

    `groups` are names, the smallest size first.
    """

    groups: tuple[str, ...]
    slope: float


class ListedGroup(
    Struct, frozen=True, kw_only=True, omit_defaults=True, rename={"count": "cases", "neighbours": "turns"}
):
    """What a list of problems says of a test group."""

    name: str
    count: Annotated[int, Meta(ge=1, le=1_000_000)]
    points: Annotated[int, Meta(ge=0, le=FULL_SCORE)]
    level: KataLevel | None = None  # None where the problem's groups have none


class Group(ListedGroup, frozen=True, kw_only=True):
    """A test group: `count` cases of one draw, named after what they probe."""

    name: Name
    about: Annotated[str, Meta(min_length=1)]  # one sentence for a person: what the group probes
    tolerance: Tolerance = Tolerance()
    seed: int | str  # with which the seed text of each case begins
    skills: tuple[Annotated[str, Meta(min_length=1)], ...] = ()  # what a run shows that passes it
    kills: tuple[str, ...] = ()  # the mistakes it catches
    line: int = 0  # of problem.py, where it is declared
    size: Annotated[int, Meta(ge=1, le=10**9)] | None = None  # n, where its cases are big
    time_limit: Annotated[float, Meta(ge=1, le=1e6)] | None = None  # its own, as `TimeRule.limit`
    limits: GroupLimits | None = None  # its own
    neighbours: bool = False  # whether a case differs from the one before in one parameter only


class ShownSkill(Struct, frozen=True):
    """What the problem teaches: a skill's name, and the groups that show it when one run passes them all."""

    name: str
    groups: tuple[str, ...]


class Source(Struct, frozen=True, forbid_unknown_fields=True):
    """`[source]`: where the problem comes from; what its setter says nothing of is empty."""

    authors: tuple[Annotated[str, Meta(pattern=_AUTHOR)], ...] = ()
    license: Annotated[str, Meta(pattern=_LINE)] = ""
    origin: Annotated[str, Meta(pattern=_LINE)] = ""


class Example(Struct, frozen=True):
    """A worked example of the statement: the call and the answer it shows."""

    case: Case
    wanted: Any
    line: int  # in statement.md, from 1


class Titled(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """What problem.toml says of a problem and a list shows."""

    title: str
    tier: Tier
    summary: str
    entry: Annotated[str, Meta(pattern=_ENTRY)] = ""  # the function that is called; none of programs alone
    sets: tuple[Name, ...] = ()  # the practice sets that it is in
    place: int = 1_000_000  # in its tier's order


class Listed(Titled, frozen=True, kw_only=True, omit_defaults=True):
    """What a list of problems says of one: as much as is read of each from the cache."""

    id: str
    groups: tuple[ListedGroup, ...]

    @property
    def levels(self) -> tuple[KataLevel, ...]:
        """The levels of its groups, the easier first; none where the groups are of one kind."""
        return tuple(level for level in KataLevel if self.of_level(level))

    def of_level(self, level: KataLevel) -> tuple[ListedGroup, ...]:
        """Its groups of that level."""
        return tuple(group for group in self.groups if group.level is level)


class Problem(Listed, frozen=True, kw_only=True):
    """One problem, whole; `folder` holds problem.toml, problem.py, statement.md and pins.json.

    `key` is the hash of all that it was made from.
    """

    answer: Type
    parameters: tuple[Parameter, ...]
    limits: GroupLimits
    groups: tuple[Group, ...]
    folder: Path
    solutions: Path  # solutions/<id>; need not exist
    time: TimeRule | None = None  # where there is none, only `limits` bound the time
    examples: tuple[Example, ...] = ()
    statement: str = ""  # with its placeholders filled in
    growth: GrowthRule | None = None
    source: Source = Source()
    formatted: bool = False  # whether problem.py says what a program reads and writes
    talks: bool = False  # whether such a program is talked with, and there are no answers
    methods: bool = False  # whether the entry is a class, and a case is calls in a row on one object
    key: str = ""

    @property
    def skills(self) -> tuple[ShownSkill, ...]:
        """What it teaches, in the order of its groups."""
        names = dict.fromkeys(skill for group in self.groups for skill in group.skills)
        return tuple(
            ShownSkill(name, tuple(group.name for group in self.groups if name in group.skills))
            for name in names
        )

    @property
    def has_hints(self) -> bool:
        """Whether there is anything that `judge hint` could give."""
        return (self.folder / "hints.md").is_file()

    def limits_of(self, group: Group) -> GroupLimits:
        """The bounds of one of its groups."""
        return group.limits or self.limits

    @property
    def called(self) -> str:
        """What a box is asked to call: a function, or a class whose objects are."""
        return f"{self.entry}()" if self.methods else self.entry

    def calls(self, cases: Sequence[Case]) -> Sequence[tuple[Any, ...]]:
        """The cases as a submission receives them: with lists and arrays, where a case has tuples."""
        from judge.values import parameters

        taken = [parameter.type for parameter in self.parameters]
        if all(type_.is_plain for type_ in taken):
            return cases
        return [tuple(map(parameters.argument, taken, case)) for case in cases]

    def kept(self, case: Case) -> Case:
        """A case as a draw, a literal or a person gives it, with its dicts as pairs."""
        from judge.values import parameters

        taken = [parameter.type for parameter in self.parameters]
        return tuple(map(parameters.kept, taken, case)) if len(taken) == len(case) else case

    def named(self, case: Case) -> dict[str, Any]:
        """A case's arguments by parameter name: tuples as such, lists and arrays as lists."""
        from judge.values import parameters

        return {
            parameter.name: parameters.listed(parameter.type, value)
            for parameter, value in zip(self.parameters, case, strict=True)
        }

    def group(self, name: str) -> Group | None:
        """The group of that name, or None."""
        return next((group for group in self.groups if group.name == name), None)

    def fault(self, what: str, remedy: str | None, line: int = 0, file: str = "problem.py") -> ProblemError:
        """The fault of what stands on that line of one of its files; without a line, of the whole file."""
        where = f"{self.id}/{file}" + f":{line}" * (line > 0)
        return ProblemError(what, where=where, remedy=remedy)


def chosen_groups(problem: Problem, names: Sequence[str], level: str | None = None) -> tuple[Group, ...]:
    """The problem's groups of those names, all of them where none is named; of one level if that is given
    and the problem has levels.

    Raises:
        UsageError: the problem has no group of that name, no such level, or no group that is both.
    """
    known = [group.name for group in problem.groups]
    for name in names:
        if name not in known:
            raise UsageError(f"{problem.id} has no group {name!r}", remedy=meant(name, known, "it has"))
    chosen = tuple(group for group in problem.groups if not names or group.name in names)
    if level is not None and level not in LEVELS:
        raise UsageError(f"there is no level {level!r}", remedy=f"use one of {', '.join(LEVELS)}")
    if level is None or not problem.levels:
        return chosen
    found = tuple(group for group in chosen if group.level is KataLevel(level))
    if not found:
        there = ", ".join(f"{group.name} is {group.level.value}" for group in chosen if group.level)
        raise UsageError(f"no group that is named is of the {level} level", remedy=f"leave one out: {there}")
    return found


@cache
def parsed_type(text: str, folder: Path, words: Words = Words(), letters: str = "") -> Type:  # noqa: B008
    """The type of that text; `folder` has the pack's own types, if it is there. Raises TypeFault."""
    from judge.values.grammar import parse  # not for who lists problems

    return parse(text, folder if folder.is_dir() else None, words, letters)
