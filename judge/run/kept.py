"""Reading results that were kept, this judge's own and those of an older one."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import msgspec

from judge.run.result import SCHEMA, Result


def read_result(plain: Mapping[str, Any]) -> Result:
    """The result behind `Result.as_json()`, or behind an object that an older judge wrote.

    Raises:
        ValueError: it is no such object.
    """
    try:
        found = plain if plain["schema"] == SCHEMA else _from_schema_1(plain)
        return msgspec.convert(found, Result)
    except (msgspec.ValidationError, TypeError, KeyError, AttributeError) as fault:
        raise ValueError(f"this is not a result: {fault}") from fault


def _from_schema_1(plain: Mapping[str, Any]) -> dict[str, Any]:
    """Points, advice and the answers themselves were not published then."""
    time, pitfall, small = plain["time"], plain["pitfall"], plain["counterexample"]
    reference = time.get("reference") or {}
    if pitfall:
        names = pitfall["name"].split(" + ")
        pitfall = pitfall | {"names": names, "advice": [""] * len(names)}
    if small and small["replay"]:
        small = small | {"group": small["replay"].split(":")[1]}
    return {
        **plain,
        "schema": SCHEMA,
        "counterexample": small,
        "pitfall": pitfall,
        "time": {**time, "reference": reference.get("language", ""), "why": reference.get("why", "")},
        "isolation": plain["isolation"] or "",
    }
