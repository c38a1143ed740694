"""The shape of `problem.toml`, as a person writes it; load.py makes a Problem of it."""

from __future__ import annotations

from decimal import Decimal
from typing import Any

import msgspec

from judge.problem.level import KataLevel
from judge.problem.model import Tier

TomlNumber = int | Decimal  # a number of the file, never rounded


class ToleranceTable(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """`[tolerance]`, or a group's own one, which replaces it whole."""

    extent: TomlNumber = 0
    relative: TomlNumber = 0
    zero: TomlNumber = 0
    ulps: TomlNumber = 0


class LimitsTable(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """`[limits]`: the bounds of one test group."""

    cpu_seconds: TomlNumber = 2
    wall_seconds: TomlNumber = 6
    memory_mb: TomlNumber = 256
    output_mb: TomlNumber = 16
    input_mb: TomlNumber = 64


class TimeTable(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """`[time]`: the limit as a multiple of a reference solution's CPU time."""

    limit: TomlNumber
    function: str
    program: str | None = None
    needs: list[str] = []
    references: dict[str, str] = {}  # in other languages, by the language's id


class GrowthTable(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """`[growth]`: the groups it is measured in, and how far an exponent may exceed the reference's."""

    groups: list[str]
    slope: TomlNumber


class GroupTimeTable(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """`[groups.time]`: a group's own limit."""

    limit: TomlNumber


class GroupLimitsTable(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """`[groups.limits]`: a group's own bounds."""

    cpu_seconds: TomlNumber
    wall_seconds: TomlNumber | None = None


class WordsTable(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """`[words]`: the problem's own words for its answers, where a message needs them."""

    answer: str = ""
    meant: str = ""
    missing: str = ""
    order: str = ""
    unit: str = ""


class SourceTable(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """`[source]`: who wrote the problem, on which terms, and after what."""

    authors: list[str] = []
    license: str | None = None
    origin: str | None = None


class ParameterRow(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """One row of `[parameters]`: `cx = { type = "number", about = "x of the centre" }`."""

    type: str
    about: str
    low: TomlNumber = -(2**30)
    high: TomlNumber = 2**30
    smallest: TomlNumber | None = None  # 1e-30 for real numbers


class ParameterTable(ParameterRow, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """One `[[parameters]]`, of a problem whose groups stand in problem.toml."""

    name: str
    low: TomlNumber
    high: TomlNumber
    smallest: TomlNumber = 0


class GroupTable(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """One `[[groups]]`; `seed` and `count` may be missing only where the builder is "examples"."""

    name: str
    about: str
    builder: str
    points: int
    parameters: dict[str, Any] = {}
    seed: int | None = None
    count: int | None = None
    tolerance: ToleranceTable | None = None
    kills: list[str] = []
    size: int | None = None
    time: GroupTimeTable | None = None
    limits: GroupLimitsTable | None = None
    neighbours: bool = False
    level: KataLevel | None = None


class SkillTable(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """One entry of `[skills]` written as a table, for a skill that this problem brings."""

    groups: list[str]
    about: str


class HeadTable(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The whole file, where problem.py declares the groups."""

    title: str
    tier: Tier
    summary: str
    entry: str
    answer: str
    parameters: dict[str, ParameterRow]  # in the order of the call
    tolerance: ToleranceTable | None = None
    limits: LimitsTable = LimitsTable()
    time: TimeTable | None = None
    growth: TomlNumber | None = None  # by how much a submission's exponent may exceed the reference's
    words: WordsTable | None = None
    sets: list[str] = []
    place: int | None = None
    source: SourceTable | None = None


class ProblemTable(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The whole file, where it declares the groups itself."""

    title: str
    tier: Tier
    summary: str
    entry: str
    answer: str
    limits: LimitsTable
    parameters: list[ParameterTable]
    groups: list[GroupTable]
    tolerance: ToleranceTable | None = None
    bands: dict[str, TomlNumber] = {}
    words: WordsTable | None = None
    time: TimeTable | None = None
    sets: list[str] = []
    place: int | None = None
    skills: dict[str, Any] = {}  # each a list of groups, or a SkillTable
    growth: GrowthTable | None = None
    source: SourceTable | None = None


_TABLES: dict[str, type[msgspec.Struct]] = {
    "tolerance": ToleranceTable,
    "limits": LimitsTable,
    "time": TimeTable,
    "growth": GrowthTable,
    "words": WordsTable,
    "source": SourceTable,
    "parameters": ParameterTable,
    "groups": GroupTable,
    "skills": SkillTable,
}
_TABLES_OF_GROUPS: dict[str, type[msgspec.Struct]] = {"time": GroupTimeTable, "limits": GroupLimitsTable}


def fields_at(path: tuple[str | int, ...], file: type[msgspec.Struct]) -> tuple[str, ...]:
    """The keys that the table at `path` may have; `file` is the shape of the whole."""
    names = [part for part in path if isinstance(part, str)]
    if not names:
        return file.__struct_fields__
    if names[0] == "parameters" and file is HeadTable:
        return ParameterRow.__struct_fields__
    named = names[0] == "skills"  # a table of tables with names of their own
    known = _TABLES | _TABLES_OF_GROUPS if names[0] == "groups" else _TABLES
    return known[names[0] if named else names[-1]].__struct_fields__
