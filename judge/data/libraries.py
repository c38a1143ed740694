"""What real libraries come to on a kata: libraries.json beside pins.json, one line a library.

{
"ezdxf": {"library": "ezdxf", "version": "1.4.5", "groups": [19, 25], "cases": [1688, 1718], "smallest": "…"},
…
}
"""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct

from judge.data.pins import read_rows
from judge.errors import UsageError
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


LIBRARIES = "libraries.json"
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
    return read_rows(problem, LIBRARIES, LibraryRow, "--libraries")
