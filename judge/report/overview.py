"""The practice sets side by side, for the screen."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from judge.kata.overview import SetStanding, Share
from judge.kata.skills import SkillProgress, SkillState
from judge.problem.model import KataLevel
from judge.report.layout import Cell, Column, Line, Span, Style, Table, beside, hanging, line
from judge.report.levels import level_name
from judge.report.skills import counted_mistakes, failing_groups

_LABELS = 12  # the column where what follows a label begins


def overview_lines(
    title: str,
    sets: Sequence[SetStanding],
    skills: Sequence[SkillProgress],
    mistakes: Mapping[str, int],
    width: int | None,
) -> Iterator[Line]:
    """A row a set; below them the skills that were lost, and the mistakes."""
    shown = sum(skill.state is SkillState.SHOWN for skill in skills)
    yield from beside(Span(title, Style.STRONG), f"{shown} of {len(skills)} skills shown", width)
    yield line()
    titles = ("katas passed", *(level_name(level) for level in KataLevel), "skills shown")
    columns = (Column("set"), *(Column(each, right=True) for each in titles))
    yield from Table(columns, [_row(each) for each in sets]).lines(width)
    notes = [("lost", _lost(skill)) for skill in skills if skill.state is SkillState.LOST]
    notes += [("mistakes", counted_mistakes(Counter(mistakes)))] if mistakes else []
    notes += [("more", "judge progress SET lists its skills and katas, judge progress --all every one")]
    yield line()
    for label, text in notes:
        style = Style.BAD if label == "lost" else Style.FAINT
        yield from hanging(Span(label, style), Span(text), width, indent=2, column=_LABELS)


def _row(standing: SetStanding) -> list[Cell]:
    shares = (standing.katas, *standing.levels.values(), standing.skills)
    return [Span(standing.name, Style.STRONG), *map(_share, shares)]


def _share(share: Share) -> Span:
    style = Style.GOOD if share.met == share.of else Style.PLAIN if share.met else Style.FAINT
    return Span(f"{share.met} of {share.of}" if share.of else "", style)


def _lost(skill: SkillProgress) -> str:
    return f"{skill.skill.name}: fails {', '.join(failing_groups(skill))}"
