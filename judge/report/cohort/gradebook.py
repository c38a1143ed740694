"""The gradebook: a line a student, as CSV that spreadsheets open as it is meant.

Excel takes a CSV for UTF-8 only by its byte order mark; LibreOffice and Python's `utf-8-sig` skip it. A cell
that a spreadsheet would calculate, such as a student called `=1+1`, gets an apostrophe before it. So does
what would begin a cell where another separator is usual, as `;` is in half of Europe.
"""

from __future__ import annotations

import csv
import io
import re

from judge.report.cohort.parts import Cohort, Counted
from judge.report.layout import printable

BOM = "\ufeff"
_HEAD = ("student", "name", "group")
_FORMULA = re.compile(r"""(^|[;,"'|\t])(\s*)(?=[=+\-@＝＋－＠])""")


def gradebook(cohort: Cohort) -> bytes:
    """The file. Points, empty where nothing was handed in; the total; then verdict and mistake by problem."""
    written = io.StringIO()
    writer = csv.writer(written, lineterminator="\r\n")
    details = [f"{problem} {what}" for problem in cohort.problems for what in ("verdict", "mistake")]
    writer.writerow([*_HEAD, *map(cell, cohort.problems), "total", *map(cell, details)])
    for person in cohort.people:
        marks = [cohort.marks.get((person.id, problem)) for problem in cohort.problems]
        points = ["" if mark is None else mark.score for mark in marks]
        told = [cell(text) for mark in marks for text in _told(mark)]
        who = map(cell, (person.id, person.name, person.group))
        writer.writerow([*who, *points, cohort.total(person.id), *told])
    return (BOM + written.getvalue()).encode("utf-8", "backslashreplace")


def cell(text: str) -> str:
    """Text as a cell that no spreadsheet calculates; control characters are written out."""
    return _FORMULA.sub(r"\1\2'", printable(text))


def is_gradebook(start: bytes) -> bool:
    """Whether a file that begins like this is such a gradebook."""
    return start.removeprefix(BOM.encode()).startswith(",".join(_HEAD).encode())


def _told(mark: Counted | None) -> tuple[str, str]:
    return (mark.verdict.value, mark.mistake) if mark else ("", "")
