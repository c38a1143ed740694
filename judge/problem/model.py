"""What a problem is: the values read from `problems/<id>/problem.toml`, checked once and never changed."""

from __future__ import annotations

from enum import Enum
from fractions import Fraction
from pathlib import Path
from types import MappingProxyType
from typing import Any

from msgspec import Struct

Number = int | float
Point = tuple[Number, Number]
Argument = Number | Point
Case = tuple[Argument, ...]  # the arguments of one call, in the order of the problem's parameters


class AnswerKind(Enum):
    """What a submission returns."""

    COUNT = "count"  # 0, 1, 2 or None
    POINTS = "points"  # a list of 0 to 2 points (x, y)
    PARAMETER = "parameter"  # a number t, or None


class Tier(Enum):
    """How far along the path a problem stands, easiest first."""

    JUNIOR = "junior"
    MIDDLE = "middle"
    SENIOR = "senior"
    PROFESSIONAL = "professional"


class ParameterType(Enum):
    """The type of one parameter."""

    NUMBER = "number"  # an int or a float
    INTEGER = "integer"  # an int
    POINT = "point"  # a pair of numbers
    INTEGER_POINT = "integer-point"  # a pair of ints


class Parameter(Struct, frozen=True, cache_hash=True):
    """One parameter of the entry function; `low` and `high` bound each of its numbers, ends included."""

    name: str
    type: ParameterType
    low: Fraction
    high: Fraction
    about: str


class Tolerance(Struct, frozen=True):
    """How far a number may be from the exact one x, exactly: max(extent·unit, relative·|x|) + ulps·ulp(x).

    `unit` belongs to the case and is given with its exact answer, such as the size of what it is about.
    Where x is exactly 0 the bound is max(extent, zero)·unit + ulps·ulp(0).
    """

    extent: Fraction = Fraction(0)
    relative: Fraction = Fraction(0)
    zero: Fraction = Fraction(0)
    ulps: Fraction = Fraction(0)


class Limits(Struct, frozen=True):
    """The bounds of one test group: all its calls together, or its one program."""

    cpu_seconds: float
    wall_seconds: float
    memory_bytes: int
    output_bytes: int


class TimeRule(Struct, frozen=True):
    """The time limit: how many times the CPU time of a reference solution a submission may use.

    The references are files of `solutions/<id>/accepted`; `program` is for submissions run as programs.
    """

    limit: float
    function: str
    program: str | None = None


class Group(Struct, frozen=True):
    """A test group: `count` cases from one builder, named after what they probe."""

    name: str
    about: str  # one sentence for a person: what the group probes
    builder: str  # a name in the problem's BUILDERS, or "examples" for those of the statement
    parameters: MappingProxyType[str, Any]
    seed: int
    count: int
    points: int
    tolerance: Tolerance
    kills: tuple[str, ...]  # the mistakes it is there for


class ShownSkill(Struct, frozen=True):
    """What the problem teaches: a skill's name, and the groups that show it when one run passes them all.

    `about` explains a skill that the problem itself brings; of others `skills.toml` says what they are.
    """

    name: str
    groups: tuple[str, ...]
    about: str | None = None


class Example(Struct, frozen=True):
    """A worked example of the statement: the call and the answer it shows."""

    case: Case
    wanted: Any
    line: int  # in statement.md, from 1


class Problem(Struct, frozen=True):
    """One problem, whole; `folder` holds problem.toml, problem.py, statement.md and hashes.json."""

    id: str
    title: str
    tier: Tier
    summary: str
    entry: str
    answer: AnswerKind
    parameters: tuple[Parameter, ...]
    bands: MappingProxyType[str, Fraction]  # named widths the statement and `solve` share; may be empty
    limits: Limits
    groups: tuple[Group, ...]
    folder: Path
    solutions: Path  # solutions/<id>; need not exist
    time: TimeRule | None = None  # where there is none, only `limits` bound the time
    examples: tuple[Example, ...] = ()
    statement: str = ""  # with its placeholders filled in
    sets: tuple[str, ...] = ()  # the practice sets that it is in
    place: int | None = None  # in its tier's order; without one it comes last
    skills: tuple[ShownSkill, ...] = ()

    def group(self, name: str) -> Group | None:
        """The group of that name, or None."""
        return next((group for group in self.groups if group.name == name), None)
