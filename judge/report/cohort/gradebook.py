"""The gradebook: a line a student, as CSV.

Excel takes a CSV for UTF-8 only by its byte order mark; LibreOffice and Python's `utf-8-sig` skip it.
"""

from __future__ import annotations

from judge.report.cohort.parts import Cohort, Counted
from judge.report.sheet import csv_text

BOM = "\ufeff"
_HEAD = ("student", "name", "group")


def gradebook(cohort: Cohort) -> bytes:
    """The file. Points, empty where nothing was handed in; the total; then verdict and mistake by problem."""
    details = [f"{problem} {what}" for problem in cohort.problems for what in ("verdict", "mistake")]
    rows: list[list[object]] = [[*_HEAD, *cohort.problems, "total", *details]]
    for person in cohort.people:
        marks = [cohort.marks.get((person.id, problem)) for problem in cohort.problems]
        points = ["" if mark is None else mark.score for mark in marks]
        told = [text for mark in marks for text in _told(mark)]
        rows.append([person.id, person.name, person.group, *points, cohort.total(person.id), *told])
    return (BOM + csv_text(rows)).encode("utf-8", "backslashreplace")


def is_gradebook(start: bytes) -> bool:
    """Whether a file that begins like this is such a gradebook."""
    plain = start.removeprefix(BOM.encode()).replace(b'"', b"")  # an older judge quoted none of its titles
    return plain.startswith(",".join(_HEAD).encode())


def _told(mark: Counted | None) -> tuple[str, str]:
    return (mark.verdict.value, mark.mistake) if mark else ("", "")
