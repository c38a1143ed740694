"""The list of a class's students: a CSV file, as spreadsheets write it.

    id;name;group               the columns that have a meaning; so have `note` and `extra days`
    ada;Ada Lovelace;a

Without an `id` it is the name, or else the first column, that tells all of them apart. Every column goes
on to the gradebook. Commas, semicolons or tabs part the columns; the text is UTF-8, or UTF-16
with a byte order mark, and the gradebook is what the list was.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from judge.batch.folder import display_name
from judge.batch.gradebook import BOM, Sheet, listed_columns
from judge.batch.model import Submission
from judge.batch.platforms import Roster
from judge.errors import UsageError
from judge.files import read_ordinary, unreadable
from judge.report.published_klass import Student

_LARGEST = 2**24  # bytes
_LONGEST = 500  # characters of an id
_SIGNS = ",;\t"
_SEPARATOR = re.compile(r'"?sep=([,;\t])"?', re.IGNORECASE)  # a first line that Excel writes and reads
_NO_STUDENT = re.compile(r"\s*(Points Possible|points-per-question|Manual Posting.*)$")  # rows of platforms
_LATE = re.compile(r"\d.* late\b")  # in Moodle's Status, in English
_WHOLE = ("name", "full name", "student")  # titles of columns with a person's whole name
_PARTS = ("first name", "last name")
_REMEDY = "save it as CSV in UTF-8, with the columns id, name, group"


def read_students(path: Path) -> Roster:
    """The students in the order of the list, which may be a platform's own gradebook.

    Raises:
        UsageError: it cannot be read, holds nobody, or a line of it is no row; that line is told.
    """
    text, encoding = _text(path)
    sign = _separator(text)
    rows = _rows(text, path, sign)
    _, titles = next(rows, (0, list[str]()))
    titles = [*map(str.strip, titles)]
    titles = titles[: listed_columns(titles)]
    if not titles:
        raise UsageError("this list of students is empty", where=str(path), remedy=_REMEDY)
    columns = [title.casefold() for title in titles]
    kept, extra = list[tuple[int, list[str]]](), list[list[str]]()
    for number, row in rows:
        if _NO_STUDENT.match(next(filter(None, map(str.strip, row)))):
            extra.append(row[: len(titles)])
        else:
            kept.append((number, row[: len(titles)]))
    own = _own_column(columns, [row for _, row in kept])
    lines, students = dict[str, int](), list[Student]()
    for number, row in kept:
        student = _student(columns, row, own, f"{path}:{number}")
        if (line := lines.setdefault(student.id, number)) != number:
            raise _bad(
                path, number, f"{student.id} is in line {line} already", "take one of the two lines out"
            )
        students.append(student)
    if not students:
        raise UsageError("there is nobody in this list of students", where=str(path), remedy=_REMEDY)
    end = "\r\n" if "\r\n" in text else "\n"
    return Roster(students, titles, Sheet(sign, end, tuple(extra), encoding))


def _student(columns: Sequence[str], row: Sequence[str], own: int, where: str) -> Student:
    """Who stands in a row. Raises UsageError."""
    cells = dict(zip(columns, map(str.strip, row), strict=False))
    found = row[own].strip().removeprefix("#") if own < len(row) else ""
    if not found:
        remedy = "write one, or take the line out"
        raise UsageError("there is no id in this line", where=where, remedy=remedy)
    if len(found) > _LONGEST:
        raise UsageError(f"an id of {len(found):,} characters", where=where, remedy="write a shorter one")
    days = cells.get("extra days", "")
    try:
        extra = float(days.replace(",", ".") or 0)
    except ValueError:
        raise UsageError(f"extra days are {days!r}", where=where, remedy="write a number of days") from None
    whole = next(filter(None, map(cells.get, _WHOLE)), "")
    return Student(
        display_name(found),
        whole or " ".join(filter(None, map(cells.get, _PARTS))),
        cells.get("group", ""),
        cells=tuple(row),
        note=cells.get("note", ""),
        extra_days=extra,
        late=bool(_LATE.search(cells.get("status", ""))),
    )


def _own_column(columns: Sequence[str], rows: Sequence[Sequence[str]]) -> int:
    """The column that tells students apart: `id`, or one without repetitions and gaps, names first."""
    if "id" in columns:
        return columns.index("id")
    for at in sorted(range(len(columns)), key=lambda at: columns[at] not in _WHOLE):
        cells = {row[at].strip() for row in rows if at < len(row)} - {""}
        if rows and len(rows) == len(cells):
            return at
    return 0


def everyone(roster: Roster, submissions: Iterable[Submission]) -> list[Student]:
    """The students of the list, then those of the folder who are not in it; without a list all are known."""
    listed = roster.students
    others = sorted({each.student for each in submissions} - {each.id for each in listed})
    return [*listed, *(Student(each, known=not listed) for each in others)]


def _text(path: Path) -> tuple[str, str]:
    """The text, and what it is encoded in. Raises UsageError."""
    try:
        content = read_ordinary(path, _LARGEST + 1)
    except (OSError, ValueError) as fault:
        raise unreadable(path, fault, "name a CSV file") from fault
    if len(content) > _LARGEST:
        raise UsageError(f"this file is larger than {_LARGEST // 2**20} MB", where=str(path), remedy=_REMEDY)
    wide = {b"\xff\xfe": "utf-16-le", b"\xfe\xff": "utf-16-be"}
    encoding = wide.get(content[:2], "utf-8")
    try:
        return content.decode(encoding).removeprefix(BOM), encoding
    except UnicodeDecodeError as fault:
        number = content.count(b"\n", 0, fault.start) + 1
        raise _bad(path, number, f"this is not UTF-8: byte 0x{content[fault.start]:02x}") from fault


def _separator(text: str) -> str:
    """What parts the columns."""
    head = text.lstrip("\r\n").partition("\n")[0]
    told = _SEPARATOR.fullmatch(head.strip())
    return told[1] if told else max(_SIGNS, key=head.count)


def _rows(text: str, path: Path, sign: str) -> Iterator[tuple[int, list[str]]]:
    """The rows that are not empty, each with the number of the line that it begins in. Raises UsageError."""
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=sign, strict=True)
    number = 1
    try:
        for row in reader:
            if any(map(str.strip, row)) and not _SEPARATOR.fullmatch(sign.join(row)):
                yield number, row
            number = reader.line_num + 1
    except csv.Error as fault:
        raise _bad(path, number, f"this is not a line of a CSV file ({fault})") from fault


def _bad(path: Path, number: int, what: str, remedy: str = _REMEDY) -> UsageError:
    return UsageError(what, where=f"{path}:{number}", remedy=remedy)
