"""What real libraries come to on a kata: libraries.json beside pins.json, one line a library.

{
"ezdxf": {"library": "ezdxf", "version": "1.4.5", "groups": [19, 25], "cases": [1688, 1718], "smallest": "…"},
…
}
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

import msgspec
from msgspec import Struct
from msgspec.structs import asdict

from judge.errors import UsageError
from judge.files import read_ordinary, replace_file
from judge.problem import Problem
from judge.published import Published


class LibraryRow(Struct, frozen=True):
    """A library: how many groups and cases it passes, of how many, and the shortest case that it fails."""

    library: str
    version: str
    groups: tuple[int, int]
    cases: tuple[int, int]
    smallest: str = ""


class LibraryTable(Published, frozen=True):
    """The libraries of a kata, the best first; `missing` says what to install for the others."""

    problem: str
    libraries: tuple[LibraryRow, ...]
    missing: tuple[str, ...] = ()


Rows = Mapping[str, LibraryRow]  # by the name of the adapter's file


def library_table(problem: Problem) -> LibraryTable:
    """What was measured. Raises UsageError where nothing was, ProblemError for a file that is damaged."""
    if rows := read_libraries(problem):
        return table_of(problem, rows)
    raise UsageError(f"{problem.id} has no table of libraries", remedy="count has one")


def table_of(problem: Problem, rows: Rows, *missing: str) -> LibraryTable:
    """The rows, sorted."""
    best = sorted(rows.values(), key=lambda row: (-row.cases[0], row.library))
    return LibraryTable(problem.id, tuple(best), missing)


def read_libraries(problem: Problem) -> dict[str, LibraryRow]:
    """What was measured; empty if there is no such file. Raises ProblemError."""
    try:
        return msgspec.json.decode(read_ordinary(_file(problem)), type=dict[str, LibraryRow])
    except FileNotFoundError:
        return {}
    except (OSError, ValueError) as error:
        remedy = f"write it with: judge verify {problem.id} --libraries"
        raise problem.fault(f"cannot be read: {error}", remedy, file=_file(problem).name) from None


def write_libraries(problem: Problem, rows: Rows) -> None:
    """Keep what was measured. Raises ProblemError if the file cannot be written."""
    lines = ",\n".join(f"{json.dumps(name)}: {json.dumps(asdict(row))}" for name, row in rows.items())
    try:
        replace_file(_file(problem), f"{{\n{lines}\n}}\n".encode())
    except OSError as error:
        what = f"cannot be written: {error.strerror}"
        raise problem.fault(what, f"make {problem.folder} writable", file=_file(problem).name) from None


def _file(problem: Problem) -> Path:
    return problem.folder / "libraries.json"
