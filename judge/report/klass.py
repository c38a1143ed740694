"""A class on the screen: of each kata its mistakes and the groups that fail, then who needs help."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from judge.report.cohort import EQUAL_CAUTION, Cohort, MistakeBar, ProblemView
from judge.report.layout import (
    READABLE,
    Line,
    Span,
    Style,
    beside,
    cells,
    line,
    pad,
    printable,
    wrap,
)
from judge.report.values import counted

_SHOWN, _NAMES = 5, 8  # mistakes, groups and sets, and names in a row, where not everything is shown
_LABEL, _BAR = 34, 30  # columns of a label and of a bar at most
_NAME = 32  # columns of a student's name at most


def cohort_lines(
    cohort: Cohort, width: int | None, *, whole: bool = False, block: str = "▇"
) -> Iterator[Line]:
    """The class within `width` columns, folded unless the `whole` of it is asked for; bars of `block`."""
    names = {each.id: _cut(each.id) for each in cohort.people}  # as the table has them

    def listed(label: str, texts: Sequence[str], most: int = _NAMES, indent: int = 2) -> Iterator[Line]:
        shown = texts if whole else texts[:most]
        text = ", ".join(shown) + _left(len(texts) - len(shown))
        room = None if width is None else min(width, READABLE) - 4
        rows = wrap(f"{label}: {text}" if label else text, room)
        yield from (line(" " * (4 if at and label else indent), row.rstrip()) for at, row in enumerate(rows))

    for view in cohort.views:
        about = f"{view.handed_in} of {len(cohort.people)} submitted, {view.accepted} accepted"
        yield from beside(Span(view.problem, Style.STRONG), about, width)
        for bar in view.mistakes if whole else view.mistakes[:_SHOWN]:
            yield from _bar(bar, view, width, block)
            if whole:
                yield from listed("", [names[each] for each in bar.students], indent=4)
        if not whole and len(view.mistakes) > _SHOWN:
            yield line("  ", Span(_left(len(view.mistakes) - _SHOWN).removeprefix(", "), Style.FAINT))
        if view.groups:
            groups = [f"{each.name} {each.failed}" for each in view.groups]
            yield from listed("groups that fail", groups, _SHOWN)
        yield line()
    stuck = [(f"{each.problem}  {each.mistake}", each.students) for each in cohort.stuck]
    none = [("", cohort.unaccepted)] if cohort.unaccepted else []
    equal = [(f"{each.problem}  {each.how}", each.students) for each in cohort.equal]
    for head, about, found in (
        ("stuck", "the same mistake in the last two submissions", stuck),
        (
            "no accepted solution yet",
            f"{len(cohort.unaccepted)} of {counted(len(cohort.people), 'student')}",
            none,
        ),
        ("equal files", EQUAL_CAUTION, equal),
    ):
        if found:
            yield from beside(Span(head, Style.STRONG), about, width)
            for label, ids in found if whole else found[:_SHOWN]:
                yield from listed(label, [names[each] for each in ids])
            if not whole and len(found) > _SHOWN:
                yield line("  ", Span(_left(len(found) - _SHOWN).removeprefix(", "), Style.FAINT))
            yield line()


def _bar(bar: MistakeBar, view: ProblemView, width: int | None, block: str) -> Iterator[Line]:
    """`  forgotten-abs   3 ▇▇▇`: the labels of a kata are in one column."""
    longest = max(cells(printable(_words(each))) for each in view.mistakes)
    room = min(_LABEL, longest) if width is None else max(6, min(_LABEL, longest, width - 20))
    wide = _BAR if width is None else max(1, min(_BAR, width - room - 8))
    most = max(each.count for each in view.mistakes)
    blocks = block * max(1, round(bar.count * min(1.0, wide / most)))
    style = Style.PLAIN if bar.named else Style.FAINT
    first, *rest = wrap(_words(bar), room)
    yield line("  ", Span(pad(first, room), style), f" {bar.count:>3} ", Span(blocks, Style.WARNING))
    yield from (line("  ", Span(row, style)) for row in rest)


def _words(bar: MistakeBar) -> str:
    """A mistake by its name, a verdict with what it means."""
    return bar.label if bar.named else f"{bar.label}, {'not named' if bar.label == 'WA' else bar.meaning}"


def _left(number: int) -> str:
    return f", and {number:,} more: --all" if number else ""


def _cut(name: str) -> str:
    """A name that leaves room for others."""
    name = printable(name)
    return name if cells(name) <= _NAME else wrap(name, _NAME - 1)[0].rstrip() + "…"
