"""The gradebook of a class: the list of students with points, a line each.

It is CSV. Excel takes a CSV for UTF-8 only by its byte order mark; LibreOffice and Python's `utf-8-sig` skip
it. A list in UTF-16 gets its gradebook in UTF-16.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Sequence

from msgspec import Struct

from judge.report.published_klass import Cohort
from judge.report.words import printable

BOM = "\ufeff"
_HEAD = ("student", "name", "group")
_OLD = [title.encode() for title in _HEAD]  # as an earlier gradebook begins, which has no last column
_NUMBER, _TOTAL, _VERDICT, _LAST = "number", "total", " verdict", "unread"
_FUNCTION = re.compile(r"""(^|[;,"|\t])(\s*)(?=[=@＝＠]|[+\-＋－].*(?:[^\W\d]\(|[|!=@]))""", re.DOTALL)
_FORMULA = re.compile(r"""(^|[;,"'|\t])(\s*)(?=[=+\-@＝＋－＠])""")


class Sheet(Struct, frozen=True):
    """How a list of students is written; `extra` are rows of a platform, below the titles."""

    sign: str = ","
    end: str = "\r\n"
    extra: tuple[Sequence[str], ...] = ()
    encoding: str = "utf-8"


def listed_columns(titles: Sequence[str]) -> int:
    """How many columns of a list are its own: all that no gradebook has added."""
    if _TOTAL not in titles or titles[-1] != _LAST:
        return len(titles)
    end = len(titles) - 1 - titles[::-1].index(_TOTAL)
    end -= sum(title.endswith(_VERDICT) for title in titles[end:])
    return end - (titles[end - 1] == _NUMBER)


def gradebook(cohort: Cohort, sheet: Sheet, *, numbered: bool = False) -> bytes:
    """The file: the columns of the list of students as they are; the numbers that pages have for names, where
    that is asked for; points, empty where nothing was submitted; the total; then verdict and mistake by kata,
    and what could not be judged.
    """
    katas = [each.problem for each in cohort.problems]
    details = [f"{kata}{what}" for kata in katas for what in (_VERDICT, " mistake")]
    titles = [*map(listed_cell, cohort.titles or _HEAD)]
    late = ["late days"] if any(mark.late_days is not None for mark in cohort.every_mark) else []
    number = [_NUMBER] if numbered else []
    rows: list[list[object]] = [[*titles, *number, *katas, _TOTAL, *late, *details, _LAST]]
    rows += [[*cells, *[""] * (len(rows[0]) - len(cells))] for cells in sheet.extra]
    for place, person in enumerate(cohort.students, 1):
        marks = [cohort.mark(person.id, kata) for kata in katas]
        points = [mark.score if mark else "" for mark in marks]
        told = [each for mark in marks for each in ((mark.verdict.value, mark.mistake) if mark else ("", ""))]
        unlisted = map(cell, (person.id, person.name, person.group)[: 1 if cohort.titles else None])
        own = [*map(listed_cell, person.cells)] or [*unlisted]
        own = [*own, *[""] * len(titles)][: len(titles)]
        unread = cell("; ".join(cohort.unread.get(person.id, ())))
        days = [cohort.days_late(person.id)] if late else []
        own += [str(place)] * numbered
        rows.append([*own, *points, cohort.total(person.id), *days, *told, unread])
    return (BOM + csv_text(rows, sheet.sign, sheet.end)).encode(sheet.encoding, "backslashreplace")


def is_gradebook(start: bytes) -> bool:
    """Whether a file that begins like this is such a gradebook."""
    start = start.removeprefix(BOM.encode()).removeprefix(b"\xff\xfe").removeprefix(b"\xfe\xff")
    start = start.replace(b"\0", b"")  # of UTF-16
    head = start.partition(b"\n")[0].replace(b'"', b"")  # as spreadsheets do
    titles = re.split(b"[,;\t]", head.strip())
    return titles[: len(_HEAD)] == _OLD or (_TOTAL.encode() in titles and titles[-1] == _LAST.encode())


def csv_text(rows: Iterable[Iterable[object]], sign: str, end: str) -> str:
    """The rows, each with that end, and that sign between their cells."""
    written = io.StringIO()
    writer = csv.writer(written, quoting=csv.QUOTE_ALL, delimiter=sign, lineterminator=end)
    writer.writerows(rows)
    return written.getvalue()


def listed_cell(text: str) -> str:
    """A cell of a list of students as it is, unless a spreadsheet would run it."""
    return _FUNCTION.sub(r"\1\2'", text)


def cell(text: str) -> str:
    """Text as a cell that no spreadsheet calculates; control characters are written out."""
    return _FORMULA.sub(r"\1\2'", printable(text))
