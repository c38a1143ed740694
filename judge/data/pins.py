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
from typing import Any, TypeVar

import msgspec

from judge.data import GroupData
from judge.files import read_ordinary, replace_file
from judge.problem import Problem

T = TypeVar("T")
PINS = "pins.json"
Kills = Mapping[str, Collection[str]]  # by the group's name: the mistakes that it rejects


def hash_of(data: GroupData) -> str:
    """The group's hash, in hexadecimal; the same on every machine."""
    plain = [[data.cases, data.targets]]
    return hashlib.sha256(json.dumps(plain, separators=(",", ":")).encode()).hexdigest()


def read_rows(problem: Problem, file: str, kind: type[T], option: str) -> dict[str, T]:
    """The rows of a file of the problem's folder that `judge verify` writes with that option.

    Empty where it is not there. Raises ProblemError.
    """
    try:
        return msgspec.json.decode(read_ordinary(problem.folder / file), type=dict[str, kind])  # type: ignore[valid-type]
    except FileNotFoundError:
        return {}
    except OSError as error:
        what, remedy = f"cannot be read: {error.strerror}", "make it readable"
    except (ValueError, RecursionError) as error:
        what, remedy = (
            f"not the form of {file}: {error}",
            f"write it with: judge verify {problem.id} {option}",
        )
    raise problem.fault(what, remedy, file=file)


def write_rows(problem: Problem, file: str, rows: Mapping[str, Any]) -> None:
    """Write such a file, one row a line. Raises ProblemError."""
    lines = ",\n".join(f"{json.dumps(name)}: {json.dumps(row)}" for name, row in rows.items())
    try:
        replace_file(problem.folder / file, f"{{\n{lines}\n}}\n".encode())
    except OSError as error:
        what, remedy = f"cannot be written: {error.strerror}", f"make {problem.folder} writable"
        raise problem.fault(what, remedy, file=file) from None


def read_pins(problem: Problem) -> dict[str, Any]:
    """What is pinned of each group; empty if there is no such file. Raises ProblemError."""
    return read_rows(problem, PINS, dict[str, Any], "--pin")


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


def differences(pins: Mapping[str, Any], found: Mapping[str, Any]) -> list[str]:
    """What the pins and the data disagree about, a sentence each."""
    told = []
    for name, now in found.items():
        pin = pins.get(name)
        if pin is None:
            told.append(f"group {name!r} has no pinned hash")
        elif pin.get("hash") != now["hash"]:
            told.append(f"the data of group {name!r} differ from their pinned hash")
        elif pin != now:
            told.append(f"group {name!r} rejects other mistakes than its pin says")
    return told + [f"the pinned hash of {name!r} belongs to no group" for name in pins if name not in found]
