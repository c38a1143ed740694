"""The shape of `problem.toml`, as a person writes it; load.py makes a Problem of it."""

from __future__ import annotations

from decimal import Decimal

import msgspec

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


class ProblemTable(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The whole file."""

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


_TABLES: dict[str, type[msgspec.Struct]] = {
    "tolerance": ToleranceTable,
    "limits": LimitsTable,
    "time": TimeTable,
    "words": WordsTable,
    "source": SourceTable,
    "parameters": ParameterRow,
}


def fields_at(path: tuple[str | int, ...]) -> tuple[str, ...]:
    """The keys that the table at `path` may have."""
    names = [part for part in path if isinstance(part, str)]
    return _TABLES[names[0]].__struct_fields__ if names else ProblemTable.__struct_fields__
