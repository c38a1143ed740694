"""The checklist of skills, each with its state, its date and what stood in its way."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from datetime import tzinfo

from judge.kata.skills import SkillProgress
from judge.report.page.parts import SkillLine
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
