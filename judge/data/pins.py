"""Pinned hashes: a problem's hashes.json holds one for each group, so that data cannot drift unseen.

{"schema": 1, "groups": {"grid": "<sha256 of the cases and their targets, as canonical JSON>"}}
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from pathlib import Path

from judge.atomic import replace_file
from judge.data.model import GroupData
from judge.errors import ProblemError
from judge.problem import Problem
from judge.reading import read_ordinary

SCHEMA = 1
_REMEDY = "write it with: judge verify {} --pin"


def hash_of(data: GroupData) -> str:
    """The group's hash, in hexadecimal; the same on every machine."""
    plain = [[data.cases, data.targets]]
    return hashlib.sha256(json.dumps(plain, separators=(",", ":")).encode()).hexdigest()


def read_pins(problem: Problem) -> dict[str, str] | None:
    """The pinned hash of each group, or None if there is no hashes.json. Raises ProblemError."""
    where = f"{problem.id}/{_path(problem).name}"
    remedy = _REMEDY.format(problem.id)
    try:
        content = json.loads(read_ordinary(_path(problem)))
    except FileNotFoundError:
        return None
    except OSError as error:
        raise ProblemError(
            f"cannot be read: {error.strerror}", where=where, remedy="make it readable"
        ) from None
    except ValueError as error:
        raise ProblemError(f"no JSON: {error}", where=where, remedy=remedy) from None
    groups = content.get("groups") if isinstance(content, dict) and content.get("schema") == SCHEMA else None
    if not isinstance(groups, dict) or not all(isinstance(pin, str) for pin in groups.values()):
        raise ProblemError("not the form of pinned hashes", where=where, remedy=remedy)
    return groups


def write_pins(problem: Problem, groups: Sequence[GroupData]) -> None:
    """Pin the data as they are. Raises ProblemError if the file cannot be written."""
    content = {"schema": SCHEMA, "groups": {data.group.name: hash_of(data) for data in groups}}
    try:
        replace_file(_path(problem), (json.dumps(content, indent=2) + "\n").encode())
    except OSError as error:
        where = f"{problem.id}/{_path(problem).name}"
        what = f"cannot be written: {error.strerror}"
        raise ProblemError(what, where=where, remedy=f"make {problem.folder} writable") from None


def differences(pins: Mapping[str, str], groups: Sequence[GroupData]) -> list[str]:
    """What the pins and the data disagree about, a sentence each."""
    found = {data.group.name: hash_of(data) for data in groups}
    drifted = [
        f"the data of group {name!r} differ from their pinned hash"
        for name in found
        if name in pins and found[name] != pins[name]
    ]
    unpinned = [f"group {name!r} has no pinned hash" for name in found if name not in pins]
    stale = [f"the pinned hash of {name!r} belongs to no group" for name in pins if name not in found]
    return drifted + unpinned + stale


def _path(problem: Problem) -> Path:
    return problem.folder / "hashes.json"
