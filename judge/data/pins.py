"""Pins: a problem's pins.json says of each group what its data are, so that nothing drifts unseen.

{
"grid": {"hash": "<sha256 of the cases and their targets, as canonical JSON>", "cases": 180, "kills": ["…"]},
…
}

`kills` are the mistakes that the group rejects in five cases or more.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from typing import Any

import msgspec

from judge.data.model import GroupData
from judge.files import read_ordinary, replace_file
from judge.problem import Problem

Kills = Mapping[str, Collection[str]]  # by the group's name: the mistakes that it rejects


def hash_of(data: GroupData) -> str:
    """The group's hash, in hexadecimal; the same on every machine."""
    plain = [[data.cases, data.targets]]
    return hashlib.sha256(json.dumps(plain, separators=(",", ":")).encode()).hexdigest()


def pins_file(problem: Problem) -> Path:
    """Where the problem's pins are."""
    return problem.folder / "pins.json"


def read_pins(problem: Problem) -> dict[str, Any] | None:
    """What is pinned of each group, or None if there is no such file. Raises ProblemError."""
    try:
        return msgspec.json.decode(read_ordinary(pins_file(problem)), type=dict[str, Any])
    except FileNotFoundError:
        return None
    except OSError as error:
        what, remedy = f"cannot be read: {error.strerror}", "make it readable"
    except (ValueError, RecursionError) as error:
        what, remedy = f"not the form of pins: {error}", f"write it with: judge verify {problem.id} --pin"
    raise problem.fault(what, remedy, file="pins.json")


def pins_of(groups: Sequence[GroupData], kills: Kills) -> dict[str, Any]:
    """What there is to pin of each group; `kills` are the mistakes that it rejects."""
    return {
        data.group.name: {
            "hash": hash_of(data),
            "cases": len(data.cases),
            "kills": sorted(kills.get(data.group.name, ())),
        }
        for data in groups
    }


def write_pins(problem: Problem, pins: Mapping[str, Any]) -> None:
    """Pin the data as they are. Raises ProblemError if the file cannot be written."""
    rows = ",\n".join(f"{json.dumps(name)}: {json.dumps(pin)}" for name, pin in pins.items())
    try:
        replace_file(pins_file(problem), f"{{\n{rows}\n}}\n".encode())
    except OSError as error:
        what, remedy = f"cannot be written: {error.strerror}", f"make {problem.folder} writable"
        raise problem.fault(what, remedy, file="pins.json") from None


def differences(pins: Mapping[str, Any], found: Mapping[str, Any]) -> list[str]:
    """What the pins and the data disagree about, a sentence each."""
    told = []
    for name, now in found.items():
        pin = pins.get(name)
        if name not in pins:
            told.append(f"group {name!r} has no pinned hash")
        elif not isinstance(pin, dict) or pin.get("hash") != now["hash"]:
            told.append(f"the data of group {name!r} differ from their pinned hash")
        elif pin != now:
            told.append(f"group {name!r} rejects other mistakes than its pin says")
    return told + [f"the pinned hash of {name!r} belongs to no group" for name in pins if name not in found]
