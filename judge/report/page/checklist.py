"""The checklists: of skills, each with what stood in its way, and of questions, each with what ticks it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from datetime import tzinfo

from judge.kata.checklist import Section
from judge.kata.progress import Kind, RowProgress, SkillProgress, State
from judge.kata.quiz.typed import listed
from judge.report.page.parts import ReadyLine, ReadyPart, SkillLine
from judge.report.values import counted

_MOST_MISTAKES = 4


def skill_lines(skills: Iterable[SkillProgress], zone: tzinfo | None) -> Iterator[SkillLine]:
    """A line for each skill, its date in that zone."""
    for progress in skills:
        since = progress.since
        mistakes = [name for name, _ in progress.mistakes.most_common(_MOST_MISTAKES)]
        share = f"on {progress.met} of {counted(len(progress.needs), 'problem')}"
        yield SkillLine(
            name=progress.skill.name,
            about=progress.skill.about,
            state=progress.state.value,
            share=share if 0 < progress.met < len(progress.needs) else "",
            since=since.astimezone(zone) if since else None,
            attempts=progress.attempts,
            mistakes=tuple(mistakes),
        )


def ready_parts(
    parts: Iterable[tuple[Section, Sequence[RowProgress]]], zone: tzinfo | None
) -> Iterator[ReadyPart]:
    """The sections of the checklist with their questions, dates in that zone."""
    for section, rows in parts:
        yield ReadyPart(section.title, tuple(_ready(row, zone) for row in rows))


def _ready(progress: RowProgress, zone: tzinfo | None) -> ReadyLine:
    since = progress.since
    return ReadyLine(
        id=progress.row.id,
        ask=progress.row.ask,
        state=progress.state.value,
        by=(", " if progress.state is State.SHOWN else ", or ").join(_by(progress)),
        since=since.astimezone(zone) if since else None,
    )


def _by(progress: RowProgress) -> Iterator[str]:
    """What ticks the question; where nothing does, all that would."""
    ticked = progress.state is State.SHOWN
    for kind in Kind:
        found = [each for each in progress.of(kind) if (each.since and not each.lost) or not ticked]
        if not found:
            continue
        if kind is Kind.CARD:
            yield counted(len(found), "card")
            continue
        names = [f"“{each.name}”" if kind is Kind.SKILL else each.name for each in found]
        if kind is Kind.BROKEN:  # each of them is enough
            yield f"broken {listed(names, 'and' if ticked else 'or')}"
        else:
            yield f"{kind.value}{'s' if len(names) > 1 else ''} {listed(names, 'and')}"
