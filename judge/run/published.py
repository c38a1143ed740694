"""A result read back from its published object (schema 1), as whoever judged elsewhere sends it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import msgspec

from judge.problem import Verdict
from judge.problem.model import KataLevel
from judge.run.result import (
    Against,
    Failure,
    GroupResult,
    LevelResult,
    Mode,
    Pitfall,
    Ratio,
    Result,
    Timing,
)


def result_of(
    published: Mapping[str, Any],
    points: Mapping[str, int] | None = None,
    advice: Mapping[str, str] | None = None,
) -> Result:
    """The result behind `Result.as_json()`.

    What is not published is not there: the wrong cases, notes, how time grew. `points` are what the problem's
    groups are worth, and `advice` is what its mistakes are told, both by name.

    Raises:
        ValueError, KeyError, TypeError: it is no such object.
    """
    points, advice = points or {}, advice or {}
    failure, pitfall = published["failure"], published["pitfall"]
    return Result(
        problem=published["problem"],
        submission=published["submission"],
        mode=Mode(published["mode"]),
        verdict=Verdict(published["verdict"]),
        groups=tuple(_group(each, points) for each in published["groups"]),
        failure=Failure(**failure) if failure else None,
        time=_timing(published["time"]),
        memory_bytes=published["memory_bytes"],
        isolation=published["isolation"] or "",
        counterexample=published["counterexample"],
        pitfall=_pitfall(pitfall, advice) if pitfall else None,
        levels=msgspec.convert(published.get("levels", ()), tuple[LevelResult, ...]),
    )


def _group(plain: Mapping[str, Any], points: Mapping[str, int]) -> GroupResult:
    level = plain.get("level")
    return GroupResult(
        name=plain["name"],
        verdict=Verdict(plain["verdict"]),
        cases=plain["cases"],
        passed=plain["passed"],
        worst_ulps=plain["worst_ulps"],
        cpu_seconds=plain["cpu_seconds"],
        points=points.get(plain["name"], 0),
        level=KataLevel(level) if level else None,
    )


def _timing(plain: Mapping[str, Any]) -> Timing:
    return Timing(
        cpu_seconds=plain["cpu_seconds"],
        wall_seconds=plain["wall_seconds"],
        ratio=msgspec.convert(plain["ratio"], Ratio | None),
        borderline=plain["borderline"],
        import_seconds=plain.get("import_seconds", 0.0),
        against=msgspec.convert(plain.get("reference"), Against | None),
    )


def _pitfall(plain: Mapping[str, Any], advice: Mapping[str, str]) -> Pitfall:
    names = tuple(plain["name"].split(" + "))
    lines = tuple((each["wrong"], each["right"]) for each in plain.get("lines", ()))
    told = tuple(advice.get(name, "") for name in names)
    return Pitfall(names, plain["score"], told, tuple(plain.get("perhaps", ())), lines)
