"""A run's published result (schema 1) read back, with only what the page shows of it."""

from __future__ import annotations

from typing import Any

import msgspec
from msgspec import Struct

from judge.errors import HistoryError
from judge.kata.history import Run
from judge.run.thresholds import Threshold


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


class TimeRecord(Struct, frozen=True):
    """What a run says of time."""

    ratio: RatioRecord | None = None


class Record(Struct, frozen=True):
    """One run's result."""

    groups: tuple[GroupRecord, ...] = ()
    failure: CaseRecord | None = None
    counterexample: CaseRecord | None = None
    time: TimeRecord = TimeRecord()
    thresholds: tuple[Threshold, ...] = ()


def read_record(run: Run) -> Record:
    """What was kept of a run; of a result that is damaged or of another form, nothing."""
    try:
        return msgspec.convert(run.result, Record)
    except (HistoryError, msgspec.ValidationError):
        return Record()
