"""The table of a class, students by problems: a verdict and points in each cell, footnotes below.

A class of many problems is laid out in blocks as wide as the screen. What differs between rows, their machine
and isolation, is a letter in the cell; the footnote says what it stands for.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from string import ascii_lowercase

from judge.batch.model import Row, Student
from judge.batch.outcome import Outcome, counting
from judge.problem import Verdict
from judge.report.layout import Line, Span, Style, cells, line, pad, printable, wrap
from judge.report.values import counted

_GAP = "  "
_NAME = 18  # columns for a student at most
_HEAD = 9  # columns of a problem's name in a line of its own at most
_NOTHING = "–"
_MOST_FAULTS = 20
_STYLES = {Verdict.AC.value: Style.GOOD, Verdict.JE.value: Style.WARNING}
_COPY, _SEVERAL, _BUSY, _UNKNOWN = "=", "+", "~", "?"
_MEANING = {
    _COPY: "the same text as in another file, judged once",
    _SEVERAL: "the best of several files",
    _BUSY: "timed while the machine was busy with other things",
    _UNKNOWN: "not in the list of students",
}


def table_lines(outcome: Outcome, width: int | None) -> Iterator[Line]:
    """The table, its footnotes, what was not judged and why, and a line that sums it up."""
    counts = counting(outcome.rows)
    places = _places(counts.values())
    several = Counter((row.student, row.problem) for row in outcome.rows)
    marks = {at: _marks(row, places, several[at]) for at, row in counts.items()}
    columns = [_column(problem, outcome.students, counts, marks) for problem in outcome.problems]
    columns += _totals(outcome, counts)
    names = [_name(student) for student in outcome.students]
    if names and outcome.problems:
        yield from _blocks(names, columns, width)
        yield line()
    used = {mark for found in marks.values() for mark in found if mark in _MEANING}
    used |= {_UNKNOWN} if any(not student.known for student in outcome.students) else set()
    for mark in (mark for mark in _MEANING if mark in used):
        yield from _note(f"{mark} {_MEANING[mark]}", width)
    for text in _where(places):
        yield from _note(text, width)
    idle = [
        student.id
        for student in outcome.students
        if not any(row.student == student.id for row in outcome.rows)
    ]
    if idle and not outcome.left:
        yield from _note(f"nothing handed in: {', '.join(idle)}", width)
    faults = [row for row in outcome.rows if row.verdict == Verdict.JE.value]
    for row in faults[:_MOST_FAULTS]:
        yield from _note(f"{row.file}: {_why(row)}", width, Style.WARNING)
    if len(faults) > _MOST_FAULTS:
        yield from _note(
            f"… and {len(faults) - _MOST_FAULTS} more; --json has them all", width, Style.WARNING
        )
    yield from _note(_sum(outcome, counts), width, Style.STRONG)


def _why(row: Row) -> str:
    return row.result.failure.message if row.result.failure else ""


Column = tuple[list[str], list[Span]]  # the lines of its head, and its cells


def _blocks(names: Sequence[Span], columns: Sequence[Column], width: int | None) -> Iterator[Line]:
    """The columns beside the names, as many at a time as there is room for."""
    first = max(cells(name.text) for name in names)
    while columns:
        fit, used = 0, first
        while fit < len(columns):
            used += len(_GAP) + _width(columns[fit])
            if width is not None and used > width and fit:
                break
            fit += 1
        yield from _block(names, first, columns[:fit])
        columns = columns[fit:]
        if columns:
            yield line()


def _block(names: Sequence[Span], first: int, columns: Sequence[Column]) -> Iterator[Line]:
    height = max(len(head) for head, _ in columns)
    for level in range(height):
        heads = [["", *[""] * (height - len(head)), *head][level + 1] for head, _ in columns]
        parts = [pad(text, _width(column)) for text, column in zip(heads, columns, strict=True)]
        yield line(Span(_GAP.join([" " * first, *parts]).rstrip(), Style.FAINT))
    for at, name in enumerate(names):
        row: list[str | Span] = [Span(pad(name.text, first), name.style)]
        for column in columns:
            cell = column[1][at]
            last = column is columns[-1]
            row += [_GAP, Span(cell.text if last else pad(cell.text, _width(column)), cell.style)]
        yield line(*row)


def _width(column: Column) -> int:
    return max(cells(text) for text in (*column[0], *(cell.text for cell in column[1])))


def _column(
    problem: str,
    students: Sequence[Student],
    counts: dict[tuple[str, str], Row],
    marks: dict[tuple[str, str], str],
) -> Column:
    found = []
    for student in students:
        at = student.id, problem
        row = counts.get(at)
        if row is None:
            found.append(Span(_NOTHING, Style.FAINT))
        else:
            points = "" if row.verdict == Verdict.JE.value else f" {row.score}"
            found.append(Span(f"{row.verdict}{points}{marks[at]}", _STYLES.get(row.verdict, Style.BAD)))
    return _head(problem), found


def _totals(outcome: Outcome, counts: dict[tuple[str, str], Row]) -> list[Column]:
    """How many problems each student has solved, and with how many points in all."""
    solved, points = [], []
    for student in outcome.students:
        rows = [row for (id_, _), row in counts.items() if id_ == student.id]
        solved.append(Span(f"{sum(row.accepted for row in rows)} of {len(outcome.problems)}"))
        points.append(Span(str(sum(row.score for row in rows))))
    return [(["solved"], solved), (["points"], points)] if len(outcome.problems) > 1 else []


def _head(problem: str) -> list[str]:
    """A problem's name, over as many lines as it has parts that do not fit beside each other."""
    lines = [""]
    for part in problem.replace("-", "-\0").split("\0"):
        if lines[-1] and cells(lines[-1] + part) > _HEAD:
            lines.append("")
        lines[-1] += part
    return lines


def _name(student: Student) -> Span:
    text = printable(student.id)
    while cells(text) > _NAME:
        text = text.removesuffix("…")[:-1] + "…"
    return Span(text + ("" if student.known else _UNKNOWN))


def _marks(row: Row, places: dict[tuple[str, str], str], several: int) -> str:
    where = places.get((row.machine, row.isolation), "")
    busy = _BUSY if row.done.busy else ""
    return (_COPY if row.copied else "") + (_SEVERAL if several > 1 else "") + busy + where


def _places(rows: Iterable[Row]) -> dict[tuple[str, str], str]:
    """Where rows were judged and how they were held, the most frequent first; each other one has a letter."""
    found = Counter((row.machine, row.isolation) for row in rows if row.isolation)
    letters = ["", *(a + b for a in ("", *ascii_lowercase) for b in ascii_lowercase)]
    return {place: letters[at % len(letters)] for at, (place, _) in enumerate(found.most_common())}


def _where(places: dict[tuple[str, str], str]) -> Iterator[str]:
    for (machine, isolation), letter in places.items():
        what = f"{isolation} isolation on {machine or 'a machine without a name'}"
        yield f"{letter} {what}" if letter else f"judged with {what}"


def _sum(outcome: Outcome, counts: dict[tuple[str, str], Row]) -> str:
    solved = sum(row.accepted for row in counts.values())
    students, problems = counted(len(outcome.students), "student"), counted(len(outcome.problems), "problem")
    left = f"; {counted(outcome.left, 'file')} left to judge" if outcome.left else ""
    return f"{solved} of {len(counts)} accepted, {students}, {problems}{left}"


def _note(text: str, width: int | None, style: Style = Style.FAINT) -> Iterator[Line]:
    for each in wrap(text, width):
        yield line(Span(each, style))
