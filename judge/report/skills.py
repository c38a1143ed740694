"""The checklist of skills for the screen."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from judge.kata.skills import SkillProgress, SkillState
from judge.report.history import day
from judge.report.layout import Cell, Column, Line, Span, Style, Table, beside, hanging, line

_STYLES = {
    SkillState.OPEN: Style.FAINT,
    SkillState.SHOWN: Style.GOOD,
    SkillState.LOST: Style.BAD,
}
_LABELS = 12  # the column where what follows a label begins
_WIDE = 110  # columns from which a row has room for a sentence


def progress_lines(
    title: str, skills: Sequence[SkillProgress], mistakes: Mapping[str, int], width: int | None
) -> Iterator[Line]:
    """A row a skill, ticked or not, and on how many of its problems it was shown if not on all.

    What is not yet shown is explained where there is room for it.
    """
    shown = sum(skill.state is SkillState.SHOWN for skill in skills)
    yield from beside(Span(title, Style.STRONG), f"{shown} of {len(skills)} skills shown", width)
    yield line()
    explained = width is None or width >= _WIDE
    columns = (
        Column("skill"),
        Column("shown"),
        Column("since"),
        Column("tries", right=True),
        Column("what it asks" if explained else "mistakes", flexible=True),
    )
    yield from Table(columns, [_row(skill, explained=explained) for skill in skills]).lines(width)
    if mistakes:
        yield line()
        text = Span(counted_mistakes(mistakes))
        yield from hanging(Span("mistakes", Style.FAINT), text, width, indent=2, column=_LABELS)


def _row(progress: SkillProgress, *, explained: bool) -> list[Cell]:
    since = day(progress.since) if progress.since else ""
    return [
        Span(progress.skill.name, Style.FAINT if progress.state is SkillState.OPEN else Style.PLAIN),
        Span(_said(progress), _STYLES[progress.state]),
        Span(since, Style.FAINT),
        Span(str(progress.attempts or ""), Style.FAINT),
        Span(" ".join(_remarks(progress, explained=explained)), Style.FAINT),
    ]


def _remarks(progress: SkillProgress, *, explained: bool) -> Iterator[str]:
    """What stands in the way: the groups that fail again, what is asked for, the mistakes made."""
    if progress.state is SkillState.LOST:
        yield f"Fails {', '.join(failing_groups(progress))}."
    elif progress.state is not SkillState.SHOWN and explained:
        yield progress.skill.about
    if progress.mistakes:
        made = counted_mistakes(progress.mistakes)
        yield f"Mistakes: {made}." if explained else made


def _said(progress: SkillProgress) -> str:
    if progress.state is SkillState.SHOWN and progress.met < len(progress.needs):
        return f"✓ {progress.met} of {len(progress.needs)}"
    return {SkillState.SHOWN: "✓", SkillState.LOST: "lost"}.get(progress.state, "")


def failing_groups(progress: SkillProgress) -> list[str]:
    """The groups that were passed and no longer are, with their problem."""
    lost = [need for need in progress.needs if need.lost]
    return [f"{need.need.problem} {group}" for need in lost for group in need.failing]


def counted_mistakes(mistakes: Mapping[str, int]) -> str:
    """`absolute-epsilon 3 ×, no-clamp`, the most frequent first."""
    found = Counter(mistakes).most_common()
    return ", ".join(name if number == 1 else f"{name} {number} ×" for name, number in found)
