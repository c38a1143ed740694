"""The checklist of questions for the screen."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from judge.kata.checklist import Evidence, Kind, RowProgress, Section
from judge.kata.skills import SkillState
from judge.report.history import day
from judge.report.layout import Cell, Column, Line, Span, Style, Table, beside, hanging, line

_STYLES = {SkillState.OPEN: Style.FAINT, SkillState.SHOWN: Style.GOOD, SkillState.LOST: Style.BAD}
_SAID = {SkillState.OPEN: "", SkillState.SHOWN: "✓", SkillState.LOST: "lost"}
_WORDS = {Kind.KATA: "kata", Kind.SKILL: "skill", Kind.CARD: "card", Kind.BROKEN: "broken"}
_COLUMN = 9  # where what follows a label begins

Parts = Sequence[tuple[Section, Sequence[RowProgress]]]


def ready_lines(parts: Parts, width: int | None) -> Iterator[Line]:
    """The rows of the first section, and how many of each other one are ticked."""
    if not parts:
        return
    (first, rows), *others = parts
    yield from section_lines(first, rows, width)
    if others:
        yield line()
        counts = ", ".join(f"{section.title} {_ticked(own)} of {len(own)}" for section, own in others)
        yield from hanging(Span("more", Style.FAINT), Span(counts), width, indent=2, column=_COLUMN)
    text = "judge progress --rows lists every question, with what drills it"
    yield from hanging(Span("then", Style.FAINT), Span(text), width, indent=2, column=_COLUMN)


def section_lines(section: Section, rows: Sequence[RowProgress], width: int | None) -> Iterator[Line]:
    """A section: a row each, ticked or not, with the command that drills it."""
    yield from beside(Span(section.title, Style.STRONG), f"{_ticked(rows)} of {len(rows)}", width)
    columns = (
        Column("row"),
        Column("", spare=True),
        Column("since", spare=True),
        Column("drill with"),
        Column("question", flexible=True),
    )
    yield from Table(columns, [_row(each) for each in rows]).lines(width)


def _row(progress: RowProgress) -> list[Cell]:
    since = day(progress.since) if progress.since else ""
    return [
        Span(progress.row.id, Style.STRONG),
        Span(_SAID[progress.state], _STYLES[progress.state]),
        Span(since, Style.FAINT),
        Span(next(iter(progress.drills), ""), Style.FAINT),
        Span(progress.row.ask, Style.FAINT if progress.state is SkillState.OPEN else Style.PLAIN),
    ]


def row_lines(progress: RowProgress, width: int | None) -> Iterator[Line]:
    """One row with all that may tick it, and every command that drills it."""
    state = {SkillState.OPEN: "not yet", SkillState.LOST: "lost"}.get(progress.state)
    said = state or f"since {day(progress.since)}" if progress.since else state or ""
    yield from beside(Span(f"{progress.row.id}  {progress.row.ask}", Style.STRONG), said, width)
    yield line()
    columns = (Column("by"), Column(""), Column("since"), Column("name", flexible=True))
    yield from Table(columns, [_evidence(each) for each in progress.evidence]).lines(width)
    yield line()
    for place, command in enumerate(progress.drills):
        yield line("  ", Span("drill" if not place else "     ", Style.FAINT), "  ", command)


def _evidence(each: Evidence) -> list[Cell]:
    state = SkillState.LOST if each.lost else SkillState.SHOWN if each.since else SkillState.OPEN
    return [
        Span(_WORDS[each.kind], Style.FAINT),
        Span(_SAID[state], _STYLES[state]),
        Span(day(each.since) if each.since else "", Style.FAINT),
        each.name,
    ]


def _ticked(rows: Sequence[RowProgress]) -> int:
    return sum(row.state is SkillState.SHOWN for row in rows)
