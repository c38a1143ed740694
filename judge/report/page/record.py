"""A run's published result (schema 1) read back, with only what the page shows of it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import msgspec
from msgspec import Struct

from judge.errors import HistoryError
from judge.kata.events import Run


class GroupRecord(Struct, frozen=True):
    """One test group of a run."""

    name: str
    verdict: str
    cases: int
    passed: int


class CaseRecord(Struct, frozen=True):
    """A failing case, or a smaller one like it; `group` and `case` say which it is where it has a place."""

    message: str
    group: str | None = None
    case: int | None = None
    input: dict[str, Any] | None = None
    expected: str | None = None
    got: str | None = None
    replay: str | None = None
    printed: str = ""


class RatioRecord(Struct, frozen=True):
    """A time ratio with its quartiles."""

    median: float
    low: float
    high: float
    pairs: int
    unreliable: str = ""


class PointRecord(Struct, frozen=True):
    """The CPU seconds of one case; the submission takes so many at least, where it has not `ended`."""

    group: str
    size: int
    cpu_seconds: float
    reference_seconds: float
    ended: bool = True


class GrowthRecord(Struct, frozen=True):
    """How the time grew with n; runs of older judges have no `points`."""

    exponent: float
    reference: float
    slope: float
    points: tuple[PointRecord, ...] = ()


class ReferenceRecord(Struct, frozen=True):
    """Whose time a run in another language than Python was compared with, and why it is not its own."""

    language: str
    why: str = ""


class TimeRecord(Struct, frozen=True):
    """What a run says of time."""

    ratio: RatioRecord | None = None
    growth: GrowthRecord | None = None
    reference: ReferenceRecord | None = None


class Record(Struct, frozen=True):
    """One run's result."""

    groups: tuple[GroupRecord, ...] = ()
    failure: CaseRecord | None = None
    counterexample: CaseRecord | None = None
    time: TimeRecord = TimeRecord()


def read_record(run: Run) -> Record:
    """What was kept of a run; of a result that is damaged or of another form, nothing."""
    try:
        return record_of(run.result)
    except HistoryError:
        return Record()


def record_of(published: Mapping[str, Any]) -> Record:
    """What the page shows of a published result; of one of another form, nothing."""
    try:
        return msgspec.convert(published, Record)
    except msgspec.ValidationError:
        return Record()
