"""A class on the screen: the table of students and katas, what goes wrong in each kata, who needs help."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import accumulate

from rich.cells import cell_len
from rich.console import Group, RenderableType
from rich.text import Text

from judge.problem import Verdict
from judge.report.parts import (
    blocks,
    faint,
    head,
    indented,
    paragraph,
    strong,
    table,
    text,
    verdict_style,
    warning,
)
from judge.report.published_klass import EQUAL_CAUTION, Alike, Cohort, Grade, ProblemView
from judge.report.screen import Screen, fitted
from judge.report.words import counted
from judge.sandbox.boundary import LEVELS

_SHOWN, _NAMES, _FAULTS = 5, 8, 20  # mistakes, names in a row, files, where not all are shown
_GAP, _NAME = 2, 18  # columns between two, and of a student's name at most
_NOTHING, _WAITING = "–", "…"
_COPY, _SEVERAL, _BUSY, _LATE, _UNKNOWN = "=", "+", "~", "l", "?"
_MEANING = {
    _COPY: "the same text as in another file, judged once",
    _SEVERAL: "the best of several files",
    _BUSY: "timed while the machine was busy with other things",
    _LATE: "late",
    _WAITING: "not judged yet",
    _UNKNOWN: "not in the list of students, or fits several of it",
}


def cohort(found: Cohort, screen: Screen) -> RenderableType:
    """The table with its footnotes and a line that sums it up, then the katas, then who needs help.

    Long lists are cut on a terminal; a pipe or a file gets them whole.
    """
    whole = screen.rows is None
    unread = [f"{who}: {each}" for who, told in found.unread.items() for each in told]
    unread = _some(unread, _FAULTS, whole=whole)
    return blocks(
        *_tables(found, screen.width),
        Group(*map(faint, _footnotes(found)), *map(warning, unread), strong(_sum(found))),
        *(Group(*_kata(view, len(found.students), whole=whole)) for view in found.problems),
        *_need_help(found, whole=whole),
    )


def _need_help(found: Cohort, *, whole: bool) -> Iterator[RenderableType]:
    """Who is stuck, who has solved nothing, and whose files are equal."""
    unsolved = found.nothing_accepted
    some = f"{len(unsolved)} of {counted(len(found.students), 'student')}"
    for title, about, rows in (
        ("stuck", "the same mistake in the last two submissions", _alike(found.stuck, whole=whole)),
        ("no accepted solution yet", some, [_names(unsolved, whole=whole)] if unsolved else []),
        ("equal files", EQUAL_CAUTION, _alike(found.equal_files, whole=whole)),
    ):
        if rows:
            yield Group(head(title, faint(about)), *(indented(paragraph(each)) for each in rows))


def _alike(found: Sequence[Alike], *, whole: bool) -> list[str]:
    rows = [f"{each.problem}  {each.what}: {_names(each.students, whole=whole)}" for each in found]
    return _some(rows, _SHOWN, whole=whole)


def _tables(found: Cohort, width: int | None) -> Iterator[RenderableType]:
    """The columns beside the names, as many at a time as there is room for."""
    names = [_short(each.id) + ("" if each.known else _UNKNOWN) for each in found.students]
    columns: list[tuple[str, list[Text]]] = [
        (view.problem, [_cell(found, each.id, view.problem) for each in found.students])
        for view in found.problems
    ]
    if len(columns) > 1:
        own = [found.marks.get(each.id, {}).values() for each in found.students]
        solved = [f"{sum(mark.accepted for mark in marks)} of {len(columns)}" for marks in own]
        columns.append(("solved", [text(each) for each in solved]))
        columns.append(("points", [text(str(found.total(each.id))) for each in found.students]))
    while names and columns:
        wide = (_GAP + max(len(title), *(each.cell_len for each in column)) for title, column in columns)
        used = accumulate(wide, initial=max(map(cell_len, names)))
        fit = max(sum(width is None or end <= width for end in used) - 1, 1)
        titles, cells = zip(*columns[:fit], strict=True)
        yield table(zip(map(text, names), *cells, strict=True), "", *titles, prose=None)
        columns = columns[fit:]


def _short(name: str) -> str:
    """A name that fits, with the number that tells it from another one."""
    plain, sign, number = name.rpartition(" (")
    room = _NAME - cell_len(sign + number)
    return fitted(plain, room) + sign + number if sign and room > _NAME // 2 else fitted(name, _NAME)


def _cell(found: Cohort, student: str, problem: str) -> Text:
    mark = found.mark(student, problem)
    if mark is None:
        return faint(_WAITING if problem in found.waiting.get(student, ()) else _NOTHING)
    points = "" if mark.verdict is Verdict.JE else f" {mark.score}"
    return text(f"{mark.verdict.value}{points}{_signs(mark)}", verdict_style(mark.verdict))


def _signs(mark: Grade) -> str:
    return (_COPY * mark.copied) + (_SEVERAL * (mark.handins > 1)) + (_BUSY * mark.busy) + (_LATE * mark.late)


def _footnotes(found: Cohort) -> Iterator[str]:
    used = {sign for mark in found.every_mark for sign in _signs(mark)}
    used |= {_UNKNOWN for each in found.students if not each.known} | ({_WAITING} if found.left else set())
    yield from (f"{sign} {meaning}" for sign, meaning in _MEANING.items() if sign in used)
    if len(found.machines) > 1 or any(each.isolation != LEVELS[0] for each in found.machines):
        for each in found.machines:
            count = counted(each.handins, "file")
            yield f"judged with {each.isolation} isolation on {each.machine}, {count}"
    if found.nothing_handed_in:
        yield f"nothing submitted: {', '.join(found.nothing_handed_in)}"


def _sum(found: Cohort) -> str:
    marks = found.every_mark
    solved = sum(mark.accepted for mark in marks)
    students, katas = counted(len(found.students), "student"), counted(len(found.problems), "kata")
    left = f"; {counted(found.left, 'file')} left to judge" if found.left else ""
    return f"{solved} of {len(marks)} accepted, {students}, {katas}{left}"


def _kata(view: ProblemView, students: int, *, whole: bool) -> Iterator[RenderableType]:
    """How many submitted and are accepted, the mistakes with who made them, the groups that fail."""
    yield head(view.problem, faint(f"{view.handed_in} of {students} submitted, {view.accepted} accepted"))
    shown = view.mistakes if whole else view.mistakes[:_SHOWN]
    rows: list[tuple[Text, str, Text]] = []
    for each in shown:
        who = faint(_names(each.students, whole=whole))
        rows.append(((text if each.named else faint)(each.what), str(len(each.students)), who))
    if rows:
        yield indented(table(rows, right=[1]))
    if more := len(view.mistakes) - len(shown):
        yield indented(faint(f"and {more} more"))
    if view.groups:
        groups = _some([f"{name} {failed}" for name, failed in view.groups.items()], _SHOWN, whole=whole)
        yield indented(paragraph(f"groups that fail: {', '.join(groups)}"))


def _names(students: Sequence[str], *, whole: bool) -> str:
    return ", ".join(_some([*map(_short, students)], _NAMES, whole=whole))


def _some(found: Sequence[str], most: int, *, whole: bool) -> list[str]:
    """All of a list, or the first of it and how many more there are."""
    left = 0 if whole else max(0, len(found) - most)
    return [*found[: len(found) - left], *([f"and {left:,} more"] if left else [])]
