"""A class on the screen: the table of students and katas, what goes wrong in each kata, who needs help."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from rich.cells import cell_len
from rich.console import Group, RenderableType
from rich.text import Text

from judge.problem import Verdict
from judge.report.parts import (
    Cell,
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
from judge.report.published_klass import EQUAL_CAUTION, Cohort, Counted, ProblemView
from judge.report.screen import Screen, fitted
from judge.report.words import counted
from judge.sandbox.boundary import LEVELS

_SHOWN, _NAMES, _FAULTS = 5, 8, 20  # mistakes and groups, names in a row, files, where not all are shown
_GAP, _NAME = 2, 18  # columns between two, and of a student's name at most
_NOTHING = "–"
_COPY, _SEVERAL, _BUSY, _UNKNOWN = "=", "+", "~", "?"
_MEANING = {
    _COPY: "the same text as in another file, judged once",
    _SEVERAL: "the best of several files",
    _BUSY: "timed while the machine was busy with other things",
    _UNKNOWN: "not in the list of students",
}


def cohort(found: Cohort, screen: Screen) -> RenderableType:
    """The table with its footnotes and a line that sums it up, then the katas, then who needs help.

    Long lists are cut on a terminal; a pipe or a file gets them whole.
    """
    whole = screen.rows is None
    below: list[RenderableType] = [faint(each) for each in _footnotes(found)]
    below += [warning(f"{file}: {why}") for file, why in found.unjudged[:_FAULTS]]
    if len(found.unjudged) > _FAULTS:
        below.append(warning(f"… and {len(found.unjudged) - _FAULTS} more; --json has them all"))
    return blocks(
        *_tables(found, screen.width),
        Group(*below, strong(_sum(found))),
        *(Group(*_kata(view, len(found.people), whole=whole)) for view in found.problems),
        *_need_help(found, whole=whole),
    )


def _need_help(found: Cohort, *, whole: bool) -> Iterator[RenderableType]:
    """Who is stuck, who has solved nothing, and whose files are equal."""
    some = f"{len(found.nothing_accepted)} of {counted(len(found.people), 'student')}"
    stuck = [(f"{each.problem}  {each.mistake}: ", each.students) for each in found.stuck]
    equal = [(f"{each.problem}  {each.how}: ", each.students) for each in found.equal_files]
    for title, about, rows in (
        ("stuck", "the same mistake in the last two submissions", stuck),
        ("no accepted solution yet", some, [("", found.nothing_accepted)] if found.nothing_accepted else []),
        ("equal files", EQUAL_CAUTION, equal),
    ):
        if rows:
            said = _some([f"{name}{_names(who, whole=whole)}" for name, who in rows], _SHOWN, whole=whole)
            yield Group(head(title, faint(about)), *(indented(paragraph(each)) for each in said))


def _tables(found: Cohort, width: int | None) -> Iterator[RenderableType]:
    """The columns beside the names, as many at a time as there is room for."""
    names = [fitted(each.id, _NAME) + ("" if each.known else _UNKNOWN) for each in found.people]
    columns: list[tuple[str, list[Text]]] = [
        (view.problem, [_mark(found.marks.get((each.id, view.problem))) for each in found.people])
        for view in found.problems
    ]
    if len(columns) > 1:
        of = f" of {len(columns)}"
        solved = Counter(who for (who, _), mark in found.marks.items() if mark.accepted)
        columns.append(("solved", [text(f"{solved[each.id]}{of}") for each in found.people]))
        columns.append(("points", [text(str(found.total(each.id))) for each in found.people]))
    while names and columns:
        fit, used = 0, max(map(cell_len, names))
        while fit < len(columns):
            title, column = columns[fit]
            used += _GAP + max(len(title), *(each.cell_len for each in column))
            if width is not None and used > width and fit:
                break
            fit += 1
        titles = ("", *(title for title, _ in columns[:fit]))
        rows = zip(map(text, names), *(column for _, column in columns[:fit]), strict=True)
        yield table(rows, *titles, prose=None)
        columns = columns[fit:]


def _mark(mark: Counted | None) -> Text:
    if mark is None:
        return faint(_NOTHING)
    points = "" if mark.verdict is Verdict.JE else f" {mark.score}"
    return text(f"{mark.verdict.value}{points}{_signs(mark)}", verdict_style(mark.verdict))


def _signs(mark: Counted) -> str:
    return (_COPY * mark.copied) + (_SEVERAL * (mark.handins > 1)) + (_BUSY * mark.busy)


def _footnotes(found: Cohort) -> Iterator[str]:
    used = {sign for mark in found.marks.values() for sign in _signs(mark)}
    used |= {_UNKNOWN for each in found.people if not each.known}
    yield from (f"{sign} {meaning}" for sign, meaning in _MEANING.items() if sign in used)
    if len(found.machines) > 1 or any(each.isolation != LEVELS[0] for each in found.machines):
        for each in found.machines:
            count = counted(each.handins, "file")
            yield f"judged with {each.isolation} isolation on {each.machine}, {count}"
    if found.nothing_handed_in and not found.left:
        yield f"nothing submitted: {', '.join(found.nothing_handed_in)}"


def _sum(found: Cohort) -> str:
    solved = sum(mark.accepted for mark in found.marks.values())
    students, katas = counted(len(found.people), "student"), counted(len(found.problems), "kata")
    left = f"; {counted(found.left, 'file')} left to judge" if found.left else ""
    return f"{solved} of {len(found.marks)} accepted, {students}, {katas}{left}"


def _kata(view: ProblemView, people: int, *, whole: bool) -> Iterator[RenderableType]:
    """How many submitted and are accepted, the mistakes with who made them, the groups that fail."""
    yield head(view.problem, faint(f"{view.handed_in} of {people} submitted, {view.accepted} accepted"))
    mistakes = view.mistakes if whole else view.mistakes[:_SHOWN]
    rows: list[Sequence[Cell]] = []
    for each in mistakes:
        who = faint(_names(each.students, whole=whole))
        rows.append(((text if each.named else faint)(each.label), str(len(each.students)), who))
    if rows:
        yield indented(table(rows, right=[1]))
    if more := len(view.mistakes) - len(rows):
        yield indented(faint(f"and {more} more"))
    if view.groups:
        groups = _some([f"{each.name} {each.failed}" for each in view.groups], _SHOWN, whole=whole)
        yield indented(paragraph(f"groups that fail: {', '.join(groups)}"))


def _names(students: Sequence[str], *, whole: bool) -> str:
    return ", ".join(_some([fitted(each, _NAME) for each in students], _NAMES, whole=whole))


def _some(found: Sequence[str], most: int, *, whole: bool) -> list[str]:
    """All of a list, or the first of it and how many more there are."""
    left = 0 if whole else max(0, len(found) - most)
    return [*found[: len(found) - left], *([f"and {left:,} more"] if left else [])]
